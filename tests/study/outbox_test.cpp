// What waits for an archive: kept whole, sent once, and lost by nothing. The archives really run.
#include "study/outbox/outbox.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <thread>

#include "dicom/synthetic.h"
#include "net/connect.h"
#include "net/no_archive.h"
#include "net/servers.h"
#include "net/sources/source_address.h"
#include "net/sources/source_list.h"
#include "study/archive/files_to_send.h"
#include "study/outbox/queue_sending.h"
#include "study/outbox/sending.h"

namespace macula::study {

namespace {

namespace fs = std::filesystem;

std::string bytesOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::unique_ptr<net::Archive> archiveAt(std::uint16_t port, const std::string& title) {
    net::Source source;
    source.name = "Hospital";
    source.peer = net::DimsePeer{.host = "127.0.0.1", .port = port, .calledAe = title};
    return *net::archiveOf(source, {});
}

// The data folder, for as long as it lives.
class DataFolder {
  public:
    explicit DataFolder(const fs::path& folder) {
        if (const char* before = std::getenv(kName)) before_ = before;
        setenv(kName, folder.c_str(), 1);
    }
    ~DataFolder() { before_ ? setenv(kName, before_->c_str(), 1) : unsetenv(kName); }
    DataFolder(const DataFolder&) = delete;
    DataFolder& operator=(const DataFolder&) = delete;

  private:
    static constexpr const char* kName = "XDG_DATA_HOME";
    std::optional<std::string> before_;
};

class OutboxTest : public ::testing::Test {
  protected:
    OutboxTest() : folder_(fs::temp_directory_path() / ("macula-outbox-" + std::to_string(getpid()))) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        series_.size = {8, 7, 3};
        files_ = dicom::test::writeFiles(folder_ / "sent", series_);
    }
    ~OutboxTest() override { fs::remove_all(folder_); }

    Outbox open(OutboxLimits limits = {.leastFreeBytes = 0, .patience = std::chrono::milliseconds(0)}) {
        auto outbox = Outbox::open(folder_ / "outbox", limits);
        EXPECT_TRUE(outbox) << (outbox ? Text() : outbox.error().message);
        return *outbox;
    }
    ToQueue request(const std::vector<fs::path>& files) {
        Progress progress;
        ToQueue request{.archive = "Hospital", .patients = filesToSend(files, progress)->patients};
        for (const fs::path& file : files) request.files.push_back({file});
        return request;
    }
    std::string queued(Outbox& outbox, const ToQueue& request) {
        Progress progress;
        const auto id = outbox.queue(request, progress);
        EXPECT_TRUE(id) << (id ? Text() : id.error().message);
        return id ? *id : std::string();
    }
    std::string queued(Outbox& outbox) { return queued(outbox, request(files_)); }
    Error notQueued(Outbox& outbox, const ToQueue& request) {
        Progress progress;
        const auto id = outbox.queue(request, progress);
        EXPECT_FALSE(id);
        EXPECT_TRUE(isEmpty());
        return id ? Error() : id.error();
    }
    OutboxSent sent(Outbox& outbox, const std::string& id, net::Archive& archive,
                    Outbox::Which which = Outbox::Which::waiting) {
        Progress progress;
        const auto sent = outbox.send(id, archive, progress, which);
        EXPECT_TRUE(sent) << (sent ? Text() : sent.error().message);
        return sent ? *sent : OutboxSent();
    }
    bool isEmpty() { return fs::is_empty(folder_ / "outbox"); }
    std::multiset<std::string> datasets(const std::vector<fs::path>& files) {
        std::multiset<std::string> all;
        for (const fs::path& file : files) all.insert(net::test::datasetBytes(file));
        return all;
    }

    fs::path folder_;
    dicom::test::SyntheticSeries series_;
    std::vector<fs::path> files_;
};

TEST_F(OutboxTest, KeepsPrivateCopiesUnderNamesThatSayNothing) {
    Outbox outbox = open();
    const std::string id = queued(outbox);
    std::multiset<std::string> before;
    for (const fs::path& file : files_) before.insert(bytesOf(file));
    fs::remove_all(folder_ / "sent");

    const auto entries = open().entries();
    ASSERT_EQ(entries.size(), 1u);
    EXPECT_EQ(entries[0].id, id);
    EXPECT_EQ(entries[0].state, OutboxState::waiting);
    EXPECT_EQ(entries[0].record.archive, "Hospital");
    ASSERT_EQ(entries[0].record.patients.size(), 1u);
    EXPECT_EQ(entries[0].record.patients[0].patientName, series_.patientName);
    EXPECT_EQ(entries[0].record.patients[0].patientId, series_.patientId);
    EXPECT_EQ(entries[0].record.queuedAt.size(), std::string("2026-11-30T08:15:00.250Z").size());
    EXPECT_EQ(fs::status(entries[0].folder).permissions(), fs::perms::owner_all);
    EXPECT_EQ(fs::status(folder_ / "outbox").permissions(), fs::perms::owner_all);

    std::multiset<std::string> kept;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "outbox")) {
        const std::string name = entry.path().filename().string();
        for (const char* said : {"2.25", "SYN", "Hospital"}) EXPECT_EQ(name.find(said), std::string::npos);
        if (entry.is_directory()) continue;
        EXPECT_EQ(fs::status(entry).permissions(), fs::perms::owner_read | fs::perms::owner_write) << name;
        if (entry.path().extension() == ".dcm") kept.insert(bytesOf(entry.path()));
    }
    EXPECT_EQ(kept, before);
}

TEST_F(OutboxTest, WhatIsStoredLeavesTheQueue) {
    const net::test::StoreServer server;
    Outbox outbox = open();
    const std::string id = queued(outbox);
    const OutboxSent outcome = sent(outbox, id, *archiveAt(server.port(), server.title()));
    EXPECT_EQ(outcome.stored, files_.size());
    EXPECT_EQ(outcome.left + outcome.refused, 0u);
    EXPECT_EQ(datasets(server.files()), datasets(files_));
    EXPECT_TRUE(isEmpty());
    Progress progress;
    EXPECT_EQ(outbox.send(id, *archiveAt(server.port(), server.title()), progress).error().code,
              ErrorCode::usage);
}

TEST_F(OutboxTest, WaitsForAnArchiveThatCannotBeReached) {
    Outbox outbox = open();
    const std::string id = queued(outbox);
    const std::uint16_t port = net::test::freePort();
    for (std::size_t tries = 1; tries <= 2; ++tries) {
        const OutboxSent outcome = sent(outbox, id, *archiveAt(port, "STORE"));
        EXPECT_EQ(outcome.left, files_.size());
        ASSERT_TRUE(outcome.trouble);
        EXPECT_EQ(outcome.trouble->code, ErrorCode::archiveNotUsable);
        const OutboxEntry entry = open().entries().at(0);
        EXPECT_EQ(entry.state, OutboxState::waiting);
        EXPECT_EQ(entry.record.tries, tries);
        ASSERT_TRUE(entry.record.trouble);
        EXPECT_EQ(entry.record.trouble->why, outcome.trouble->message) << "another reason than was told";
    }
}

TEST_F(OutboxTest, WhatTheArchiveRefusesStaysWithTheReason) {
    net::test::OrthancOptions implicitOnly;
    implicitOnly.more = {{"AcceptedTransferSyntaxes", {"1.2.840.10008.1.2"}}};
    const net::test::Orthanc server(implicitOnly);
    dicom::test::SyntheticSeries other = series_;
    other.transferSyntaxUid = "1.2.840.10008.1.2";
    other.seriesUid = "2.25.1009";
    other.size.z = 1;
    std::vector<fs::path> all = dicom::test::writeFiles(folder_ / "other", other);
    all.insert(all.end(), files_.begin(), files_.end());

    Outbox outbox = open();
    const std::string id = queued(outbox, request(all));
    const auto archive = archiveAt(server.dicomPort(), server.title());
    OutboxSent outcome = sent(outbox, id, *archive);
    EXPECT_EQ(outcome.stored, 1u);
    EXPECT_EQ(outcome.refused, files_.size());
    EXPECT_EQ(outcome.left, 0u);
    const OutboxEntry entry = open().entries().at(0);
    EXPECT_EQ(entry.state, OutboxState::refused);
    ASSERT_EQ(entry.record.files.size(), files_.size());
    for (const OutboxFile& file : entry.record.files) {
        ASSERT_TRUE(file.refused);
        EXPECT_EQ(file.refused->why, "The archive does not take the encoding of this file.");
        EXPECT_FALSE(file.refused->advice.empty());
    }
    EXPECT_FALSE(fs::exists(entry.folder / "1.dcm")) << "what is stored is kept";
    EXPECT_EQ(sent(outbox, id, *archive).stored, 0u) << "it was not asked for";
    EXPECT_EQ(open().entries().at(0).record.files.size(), files_.size());
    EXPECT_EQ(sent(outbox, id, *archive, Outbox::Which::refusedToo).refused, files_.size());
}

// Each object takes a second, so that the archive goes while the others wait.
TEST_F(OutboxTest, AnArchiveThatGoesInTheMiddleHasRefusedNothing) {
    auto server = std::make_unique<net::test::StoreServer>(std::vector<std::string>{"--sleep-after", "1"});
    const auto archive = archiveAt(server->port(), server->title());
    std::jthread power([&] {
        net::test::comes([&] { return server->files().size() >= 2; });
        server.reset();
    });
    Outbox outbox = open();
    const std::string id = queued(outbox);
    const OutboxSent outcome = sent(outbox, id, *archive);
    power.join();
    EXPECT_GE(outcome.stored, 1u);
    EXPECT_GE(outcome.left, 1u);
    EXPECT_EQ(outcome.stored + outcome.left, files_.size());
    EXPECT_EQ(outcome.refused, 0u);
    EXPECT_EQ(open().entries().at(0).state, OutboxState::waiting);
    EXPECT_EQ(open().entries().at(0).record.files.size(), outcome.left);
}

// Which of them the archive refused before it went is known by its answers.
TEST_F(OutboxTest, OnlyWhatTheArchiveAnsweredIsRefused) {
    class Goes : public net::test::NoArchive {
        Result<net::Sent> send(std::span<const fs::path> files, Progress&) override {
            return net::Sent{
                .stored = 1,
                .notSent = {{files[1], Text("It is full."), Text("Ask its administrator."), true},
                            {files[2], Text("It is gone."), Text("Try again later."), false}}};
        }
    } archive;
    Outbox outbox = open();
    const std::string id = queued(outbox);
    const OutboxSent outcome = sent(outbox, id, archive);
    EXPECT_EQ(outcome.stored, 1u);
    EXPECT_EQ(outcome.refused, 1u);
    EXPECT_EQ(outcome.left, 1u);
    ASSERT_TRUE(outcome.trouble);
    EXPECT_EQ(outcome.trouble->message, "It is gone.");
    const OutboxEntry entry = open().entries().at(0);
    EXPECT_EQ(entry.state, OutboxState::waiting);
    ASSERT_EQ(entry.record.files.size(), 2u);
    EXPECT_EQ(entry.record.files[0].refused->why, "It is full.");
    EXPECT_FALSE(entry.record.files[1].refused);
}

TEST_F(OutboxTest, WhatWaitsForOneArchiveDoesNotGoToAnotherOfItsName) {
    const DataFolder own(folder_ / "data");
    const net::test::StoreServer server;
    const auto setUp = [&](const std::string& title) {
        auto list = net::SourceList::read(net::SourceFiles::ofUser());
        net::Source source{
            .name = "Hospital",
            .peer = net::DimsePeer{.host = "127.0.0.1", .port = server.port(), .calledAe = title}};
        EXPECT_TRUE(list->put(source));
        return net::addressOf(source);
    };
    ToQueue asked = request(files_);
    asked.address = setUp("OTHER");
    Outbox outbox = open();
    const std::string id = queued(outbox, asked);
    const std::string now = setUp(server.title());

    Progress progress;
    const QueueSent refused = sendQueued(outbox, outbox.entries(), openArchiveOfUser, progress);
    EXPECT_EQ(refused.left, files_.size());
    ASSERT_TRUE(refused.trouble);
    EXPECT_EQ(refused.trouble->code, ErrorCode::usage);
    EXPECT_TRUE(server.files().empty());

    const auto moved = movedEntries(outbox.entries(), *net::SourceList::read(net::SourceFiles::ofUser()));
    ASSERT_EQ(moved.size(), 1u);
    EXPECT_EQ(moved[0].address, now);
    EXPECT_EQ(moved[0].before, asked.address);
    ASSERT_TRUE(outbox.readdress(id, now));
    EXPECT_EQ(sendQueued(outbox, outbox.entries(), openArchiveOfUser, progress).stored, files_.size());
    EXPECT_TRUE(isEmpty());
}

TEST_F(OutboxTest, ACancelledSendingKeepsAll) {
    const net::test::StoreServer server;
    Outbox outbox = open();
    const std::string id = queued(outbox);
    CancelToken token;
    token.cancel();
    Progress progress({}, token);
    const auto outcome = outbox.send(id, *archiveAt(server.port(), server.title()), progress);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->left, files_.size());
    ASSERT_TRUE(outcome->trouble);
    EXPECT_EQ(outcome->trouble->code, ErrorCode::cancelled);
    const OutboxEntry entry = open().entries().at(0);
    EXPECT_EQ(entry.record.tries, 0u) << "a person stopped it: nothing failed";
    EXPECT_FALSE(entry.record.trouble);
}

TEST_F(OutboxTest, OnlyWhatWasConfirmedIsQueued) {
    Outbox outbox = open();
    ToQueue asked = request(files_);
    asked.patients[0].patientId = "SYN2";
    EXPECT_EQ(notQueued(outbox, asked).code, ErrorCode::inputNotUsable);
    asked = request(files_);
    std::ofstream(files_[1], std::ios::trunc) << "no DICOM any more";
    EXPECT_EQ(notQueued(outbox, asked).code, ErrorCode::inputNotUsable);
    fs::remove(files_[1]);
    EXPECT_EQ(notQueued(outbox, asked).code, ErrorCode::inputNotUsable);
}

TEST_F(OutboxTest, ACancelledCopyLeavesNothing) {
    Outbox outbox = open();
    CancelToken token;
    token.cancel();
    Progress progress({}, token);
    EXPECT_EQ(outbox.queue(request(files_), progress).error().code, ErrorCode::cancelled);
    EXPECT_TRUE(isEmpty());
}

TEST_F(OutboxTest, AFullDiskIsSaidAndNothingIsHalfThere) {
    Outbox outbox = open({.leastFreeBytes = std::uintmax_t(1) << 60});
    EXPECT_EQ(notQueued(outbox, request(files_)).code, ErrorCode::outputNotWritable);
    // No file may grow beyond that, as on a disk without room.
    const ToQueue asked = request(files_);
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit most{100, 100};
        setrlimit(RLIMIT_FSIZE, &most);
        auto full = Outbox::open(folder_ / "outbox", {.leastFreeBytes = 0});
        Progress progress;
        const auto id = full ? full->queue(asked, progress) : Result<std::string>(full.error());
        _exit(!id && id.error().code == ErrorCode::outputNotWritable ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(open().entries().empty());
    EXPECT_TRUE(isEmpty());
}

TEST_F(OutboxTest, ADamagedEntryHoldsNoOtherUp) {
    const net::test::StoreServer server;
    Outbox outbox = open();
    const std::string whole = queued(outbox);
    const std::string record = bytesOf(outbox.folder() / whole / "entry.json");
    const auto damagedBy = [&](const std::string& text) {
        const std::string id = queued(outbox);
        std::ofstream(outbox.folder() / id / "entry.json", std::ios::trunc) << text;
        return id;
    };
    const auto with = [&](const std::string& before, const std::string& after) {
        std::string text = record;
        const std::size_t place = text.find(before);
        EXPECT_NE(place, std::string::npos) << before;
        return text.replace(place, before.size(), after);
    };
    const std::vector<std::string> damaged{
        damagedBy(""),
        damagedBy("[1"),
        damagedBy(with("\"1.dcm\"", "\"../../sent/1.dcm\"")),
        damagedBy(with("\"1.dcm\"", "\"/etc/1.dcm\"")),
        damagedBy(with("\"version\": 1", "\"version\": 2")),
        damagedBy(with("\"tries\": 0", "\"tries\": -1")),
        damagedBy(with("\"name\": \"2.dcm\"", "\"name\": \"2.dcm\", \"refused\": {}")),
        damagedBy(std::string(100'000, '[')),
    };
    std::map<std::string, OutboxState> states;
    for (const OutboxEntry& entry : outbox.entries()) states[entry.id] = entry.state;
    EXPECT_EQ(states.size(), damaged.size() + 1);
    EXPECT_EQ(states[whole], OutboxState::waiting);
    const auto archive = archiveAt(server.port(), server.title());
    for (const std::string& id : damaged) {
        EXPECT_EQ(states[id], OutboxState::damaged) << bytesOf(outbox.folder() / id / "entry.json");
        Progress progress;
        EXPECT_EQ(outbox.send(id, *archive, progress).error().code, ErrorCode::inputNotUsable);
        EXPECT_TRUE(fs::exists(outbox.folder() / id / "1.dcm")) << "lost";
        EXPECT_TRUE(outbox.remove(id));
    }
    EXPECT_EQ(sent(outbox, whole, *archive).stored, files_.size());
    EXPECT_TRUE(isEmpty());
}

TEST_F(OutboxTest, IsFoundByItsFirstDigitsAndRemoved) {
    Outbox outbox = open();
    const std::string id = queued(outbox);
    queued(outbox);
    EXPECT_EQ(outbox.find(id.substr(0, 8))->id, id);
    for (const std::string_view wrong : {"", "123", "../..", "zzzz", "ffffffffffffffffffffffff"})
        EXPECT_EQ(outbox.find(wrong).error().code, ErrorCode::usage) << wrong;
    EXPECT_TRUE(outbox.remove(id));
    EXPECT_EQ(outbox.remove(id).error().code, ErrorCode::usage);
    EXPECT_EQ(outbox.remove("../sent").error().code, ErrorCode::usage);
    EXPECT_TRUE(fs::exists(files_[0]));
    EXPECT_EQ(outbox.entries().size(), 1u);
}

TEST_F(OutboxTest, WhatIsBeingSentIsLeftAlone) {
    Outbox outbox = open();
    const std::string id = queued(outbox);
    const FileLock other(outbox.folder() / id / "lock");
    ASSERT_TRUE(other.isOurs());
    EXPECT_EQ(outbox.entries().at(0).state, OutboxState::sending);
    EXPECT_EQ(outbox.remove(id).error().code, ErrorCode::usage);
    Progress progress;
    EXPECT_EQ(outbox.send(id, *archiveAt(1, "STORE"), progress).error().code, ErrorCode::usage);
    EXPECT_EQ(outbox.entries().size(), 1u);
}

// Both send all that waits at the same time: nothing is lost, and no entry is sent by both.
TEST_F(OutboxTest, TwoProgramsShareTheWork) {
    const net::test::StoreServer server;
    Outbox outbox = open();
    constexpr int kEntries = 20;
    for (int i = 0; i < kEntries; ++i) queued(outbox);
    std::vector<pid_t> programs;
    for (int i = 0; i < 2; ++i) {
        const pid_t child = fork();
        if (child == 0) {
            Outbox own = open();
            Progress progress;
            const auto sent = sendQueued(
                own, own.entries(),
                [&](const OutboxRecord&) {
                    return Result<std::unique_ptr<net::Archive>>(archiveAt(server.port(), server.title()));
                },
                progress);
            _exit(sent.trouble || sent.left + sent.refused > 0 ? 255 : int(sent.stored / files_.size()));
        }
        programs.push_back(child);
    }
    int entriesSent = 0;
    for (const pid_t child : programs) {
        int status = 0;
        waitpid(child, &status, 0);
        ASSERT_TRUE(WIFEXITED(status));
        ASSERT_NE(WEXITSTATUS(status), 255);
        entriesSent += WEXITSTATUS(status);
    }
    EXPECT_EQ(entriesSent, kEntries);
    EXPECT_TRUE(isEmpty());
    EXPECT_EQ(datasets(server.files()), datasets(files_));
}

// A program that queues and sends without end is killed at a random moment. What it had queued is there
// whole, or was stored.
TEST_F(OutboxTest, KilledAtAnyMomentItHasLostNothing) {
    std::mt19937 random(7);
    const net::test::StoreServer server;
    const ToQueue asked = request(files_);
    int kept = 0;
    for (int round = 0; round < 60; ++round) {
        int steps[2];
        ASSERT_EQ(pipe(steps), 0);
        const pid_t child = fork();
        if (child == 0) {
            auto outbox = Outbox::open(folder_ / "outbox", {.leastFreeBytes = 0});
            const auto archive = archiveAt(server.port(), server.title());
            const auto say = [&](char step) { return write(steps[1], &step, 1) == 1; };
            while (outbox) {
                Progress progress;
                const auto id = outbox->queue(asked, progress);
                if (!id || !say('q')) _exit(1);
                if (!say('s') || !outbox->send(*id, *archive, progress)) _exit(2);
            }
            _exit(3);
        }
        close(steps[1]);
        std::string said;
        // On a slow machine, too, something is queued by then in each other round.
        char first = ' ';
        if (round % 2 == 0 && read(steps[0], &first, 1) == 1) said += first;
        usleep(std::uniform_int_distribution<useconds_t>(0, 60'000)(random));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself: " << status;
        std::string more(100'000, ' ');
        more.resize(std::size_t(std::max<ssize_t>(read(steps[0], more.data(), more.size()), 0)));
        said += more;
        close(steps[0]);

        Outbox outbox = open();
        const auto entries = outbox.entries();
        ASSERT_LE(entries.size(), 1u);
        if (said.ends_with('q')) {
            ASSERT_EQ(entries.size(), 1u) << "what was queued is lost";
        }
        for (const OutboxEntry& entry : entries) {
            ASSERT_EQ(entry.state, OutboxState::waiting);
            ASSERT_EQ(entry.record.files.size(), files_.size()) << "a part of it";
            for (std::size_t i = 0; i < files_.size(); ++i)
                ASSERT_EQ(bytesOf(entry.folder / entry.record.files[i].name), bytesOf(files_[i]));
            ASSERT_TRUE(outbox.remove(entry.id));
            ++kept;
        }
        ASSERT_TRUE(isEmpty()) << "left-overs";
        if (said.find('s') == std::string::npos || !entries.empty()) continue;
        ASSERT_EQ(datasets(server.files()), datasets(files_));
    }
    EXPECT_GT(kept, 0) << "no round was killed in the middle";
}

TEST_F(OutboxTest, AReasonIsKeptInWordsThatCanBeTranslated) {
    const Reason reason{Text("{} of {} in {:.1f} s: {}", 3, std::string("SYN"), 2.5, Text("no answer")),
                        Text("Try again.")};
    EXPECT_EQ(reasonFromJson(toJson(reason)), reason);
    EXPECT_EQ(reasonFromJson(nlohmann::json::parse(toJson(reason).dump()))->why.english(),
              "3 of SYN in 2.5 s: no answer");
    nlohmann::json deep = toJson(reason);
    for (int i = 0; i < 100; ++i)
        deep["why"] = {{"format", "{}"}, {"arguments", {{{"name", ""}, {"value", deep["why"]}}}}};
    EXPECT_FALSE(reasonFromJson(deep));
    for (const char* wrong : {"{}", "[]", "3", R"({"why": 3, "advice": 4})"})
        EXPECT_FALSE(reasonFromJson(nlohmann::json::parse(wrong))) << wrong;
}

}  // namespace

}  // namespace macula::study
