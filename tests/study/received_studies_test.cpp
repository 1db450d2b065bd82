// Studies that others send: where they go, when they are done, what is refused, and what a kill leaves.
#include "study/archive/received_studies.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <thread>

#include "dicom/support.h"
#include "dicom/synthetic.h"

namespace macula::study {

namespace {

namespace fs = std::filesystem;
using Verdict = net::Receiver::Verdict;

std::string bytesOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

struct Sent {
    std::string sopInstanceUid;
    fs::path file;
};

class ReceivedStudiesTest : public ::testing::Test {
  protected:
    // Files of a study of their own, and how they are named.
    std::vector<Sent> write(const std::string& studyUid, const std::string& patientId = "SYN1",
                            const std::string& seriesUid = "2.25.1001") {
        dicom::test::SyntheticSeries series;
        series.studyUid = studyUid;
        series.patientId = patientId;
        series.seriesUid = seriesUid;
        series.size.z = 3;
        std::vector<dicom::test::Slice> slices = dicom::test::slicesOf(series);
        for (std::size_t i = 0; i < slices.size(); ++i)
            slices[i].sopInstanceUid = studyUid + "." + patientId.substr(3) + "." + std::to_string(i + 1);
        const fs::path own = folder_ / ("sent" + std::to_string(written_++));
        const auto files = dicom::test::writeFiles(own, series, slices);
        std::vector<Sent> sent;
        for (std::size_t i = 0; i < files.size(); ++i) sent.push_back({slices[i].sopInstanceUid, files[i]});
        return sent;
    }
    Spool openSpool(SpoolLimits limits = {.patience = {}, .leastFreeBytes = 0}) {
        auto spool = Spool::open(folder_ / "spool", limits);
        EXPECT_TRUE(spool);
        return *spool;
    }
    static std::unique_ptr<ReceivedStudies> into(Spool& spool, ReceptionLimits limits = {}) {
        auto studies = ReceivedStudies::into(spool, limits);
        EXPECT_TRUE(studies);
        return studies ? *std::move(studies) : nullptr;
    }
    static Result<Verdict> receive(net::Receiver& receiver, const Sent& sent) {
        MACULA_TRY(const fs::path place, receiver.place());
        std::ofstream(place, std::ios::binary) << bytesOf(sent.file);
        return receiver.take(place, {.sopInstanceUid = sent.sopInstanceUid});
    }
    std::size_t arriving() {
        std::size_t count = 0;
        for (const auto& entry : fs::directory_iterator(folder_ / "spool" / "arriving"))
            count += entry.path().extension() == ".dcm" ? 1 : 0;
        return count;
    }

    dicom::test::TemporaryFolder folder_;
    int written_ = 0;
};

TEST_F(ReceivedStudiesTest, EachInstanceGoesToItsStudyHoweverTheyAreMixed) {
    Spool spool = openSpool();
    const auto studies = into(spool);
    const auto one = write("2.25.1");
    const auto two = write("2.25.2");
    const auto first = studies->receiverFor({.ae = "CT1", .address = "10.1.2.3"});
    const auto second = studies->receiverFor({.ae = "MR1", .address = "10.1.2.4"});
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(*receive(*first, one[i]), Verdict::kept);
        EXPECT_EQ(*receive(i == 0 ? *second : *first, two[i]), Verdict::kept);
        EXPECT_EQ(*receive(*second, one[i]), Verdict::hadAlready);
    }
    auto done = studies->finishAll();
    ASSERT_EQ(done.size(), 2u);
    std::ranges::sort(done, {}, &ReceivedStudy::hadAlready);
    for (const ReceivedStudy& each : done) {
        EXPECT_EQ(each.kept, 3u);
        EXPECT_EQ(each.instances, 3u);
        EXPECT_EQ(each.senders, (std::vector<std::string>{"CT1", "MR1"}));
        EXPECT_TRUE(each.messages.empty());
    }
    EXPECT_EQ(done[0].folder, spool.folderOf("2.25.2"));
    EXPECT_EQ(done[1].folder, spool.folderOf("2.25.1"));
    std::set<std::string> sent, kept;
    for (const Sent& each : one) sent.insert(bytesOf(each.file));
    for (const auto& entry : fs::directory_iterator(done[1].folder)) kept.insert(bytesOf(entry.path()));
    EXPECT_EQ(sent, kept);
    EXPECT_EQ(arriving(), 0u);
    EXPECT_TRUE(studies->finishAll().empty());
}

TEST_F(ReceivedStudiesTest, TheRecordSaysWhoSentItAndNothingOfAPromise) {
    Spool spool = openSpool();
    const auto studies = into(spool);
    const auto files = write("2.25.1");
    const auto receiver = studies->receiverFor({.ae = "CT1", .address = "10.1.2.3"});
    ASSERT_TRUE(receive(*receiver, files[0]));
    const SpoolRecord early = *readSpoolRecord(spool.folderOf("2.25.1"));
    EXPECT_EQ(early.senders, std::vector<std::string>{"CT1"}) << "should the program be killed now";
    for (const Sent& each : files) ASSERT_TRUE(receive(*receiver, each));
    ASSERT_EQ(studies->finishAll().size(), 1u);
    const auto entries = openSpool().entries();
    ASSERT_EQ(entries.size(), 1u);
    EXPECT_EQ(entries[0].record.source, "");
    EXPECT_EQ(entries[0].record.senders, std::vector<std::string>{"CT1"});
    EXPECT_EQ(entries[0].record.promised, 0u);
    EXPECT_FALSE(entries[0].record.isComplete);
    EXPECT_FALSE(entries[0].record.fetchedAt.empty());
    EXPECT_EQ(entries[0].instances, 3u);
}

TEST_F(ReceivedStudiesTest, WhatAnArchivePromisedStays) {
    Spool spool = openSpool();
    {
        const auto study = *spool.study("2.25.1");
        const auto files = write("2.25.1");
        const auto place = *study->place();
        std::ofstream(place, std::ios::binary) << bytesOf(files[0].file);
        ASSERT_EQ(*study->take(place, {}), Verdict::kept);
        ASSERT_TRUE(study->finish(
            {.source = "Hospital", .promised = 1, .isComplete = true, .fetchedAt = "2026-01-01T00:00:00Z"}));
    }
    const auto studies = into(spool);
    const auto receiver = studies->receiverFor({.ae = "CT1", .address = {}});
    ASSERT_TRUE(receive(*receiver, write("2.25.1")[1]));
    ASSERT_EQ(studies->finishAll().size(), 1u);
    const SpoolRecord record = *readSpoolRecord(spool.folderOf("2.25.1"));
    EXPECT_EQ(record.source, "Hospital");
    EXPECT_FALSE(record.isComplete) << "more came than the archive had, and maybe not all of it";
    EXPECT_EQ(record.promised, 1u);
    EXPECT_EQ(record.fetchedAt, "2026-01-01T00:00:00Z");
    EXPECT_EQ(record.senders, std::vector<std::string>{"CT1"});
}

TEST_F(ReceivedStudiesTest, AnotherPatientUnderTheSameStudyIsRefusedAndSaid) {
    Spool spool = openSpool();
    const auto studies = into(spool);
    const auto ours = write("2.25.1", "SYN1");
    const auto theirs = write("2.25.1", "SYN2");
    const auto honest = studies->receiverFor({.ae = "CT1", .address = {}});
    const auto liar = studies->receiverFor({.ae = "LIAR", .address = {}});
    ASSERT_EQ(*receive(*honest, ours[0]), Verdict::kept);
    for (const Sent& each : theirs) EXPECT_EQ(*receive(*liar, each), Verdict::refused);
    EXPECT_EQ(*receive(*honest, ours[1]), Verdict::kept);
    const auto done = studies->finishAll();
    ASSERT_EQ(done.size(), 1u);
    EXPECT_EQ(done[0].kept, 2u);
    EXPECT_EQ(done[0].refused, 3u);
    EXPECT_EQ(done[0].senders, std::vector<std::string>{"CT1"}) << "nothing is there of the other one";
    ASSERT_EQ(done[0].messages.size(), 1u);
    EXPECT_EQ(done[0].messages[0].sentence.english().find("SYN"), std::string::npos) << "names a patient";
    // A later program knows the patient by the files.
    const auto later = into(spool);
    EXPECT_EQ(*receive(*later->receiverFor({.ae = "LIAR", .address = {}}), theirs[0]), Verdict::refused);
    EXPECT_EQ(arriving(), 0u);
}

// The sender must not take for stored what is not.
TEST_F(ReceivedStudiesTest, AnInstanceThatComesWithOtherPixelsIsRefusedAndSaid) {
    Spool spool = openSpool();
    const auto studies = into(spool);
    const auto receiver = studies->receiverFor({.ae = "CT1", .address = "10.1.2.3"});
    const auto sent = write("2.25.1");
    EXPECT_EQ(*receive(*receiver, sent[0]), Verdict::kept);
    // An archive writes headers anew: that is the same object.
    const std::string before = bytesOf(sent[0].file);
    std::string changed = before;
    const std::size_t imageType = changed.find("PRIMARY\\AXIAL");
    ASSERT_NE(imageType, std::string::npos);
    changed.replace(imageType, 13, "PRIMARY\\OTHER");
    std::ofstream(sent[0].file, std::ios::binary) << changed;
    EXPECT_EQ(*receive(*receiver, sent[0]), Verdict::hadAlready);
    changed = before;
    changed.back() = static_cast<char>(changed.back() ^ 1);
    std::ofstream(sent[0].file, std::ios::binary) << changed;
    EXPECT_EQ(*receive(*receiver, sent[0]), Verdict::refused);
    changed = before.substr(0, before.size() - 2);
    std::ofstream(sent[0].file, std::ios::binary) << changed;
    EXPECT_EQ(*receive(*receiver, sent[0]), Verdict::refused);

    // The same pixels in Implicit VR, as an archive may send them.
    dicom::test::SyntheticSeries series;
    series.studyUid = "2.25.1";
    series.size.z = 3;
    series.transferSyntaxUid = "1.2.840.10008.1.2";
    auto slices = dicom::test::slicesOf(series);
    slices.resize(1);
    slices[0].sopInstanceUid = sent[0].sopInstanceUid;
    const auto implicit = dicom::test::writeFiles(folder_ / "implicit", series, slices);
    EXPECT_EQ(*receive(*receiver, {sent[0].sopInstanceUid, implicit.at(0)}), Verdict::hadAlready);

    const auto done = studies->finishAll();
    ASSERT_EQ(done.size(), 1u);
    EXPECT_EQ(done[0].kept, 1u);
    EXPECT_EQ(done[0].hadAlready, 2u);
    EXPECT_EQ(done[0].otherContents, 2u);
    ASSERT_EQ(done[0].messages.size(), 1u);
    EXPECT_EQ(done[0].messages[0].key, "came-with-other-contents");
    ASSERT_EQ(std::distance(fs::directory_iterator(done[0].folder), fs::directory_iterator()), 1);
    EXPECT_EQ(bytesOf(fs::directory_iterator(done[0].folder)->path()), before);
}

TEST_F(ReceivedStudiesTest, WhatIsNoInstanceOrNotWhatWasSaidIsRefused) {
    Spool spool = openSpool();
    const auto studies = into(spool);
    const auto receiver = studies->receiverFor({.ae = "CT1", .address = {}});
    const auto files = write("2.25.1");
    std::ofstream(folder_ / "noise") << "<html>Sign in first</html>";
    EXPECT_EQ(*receive(*receiver, {"2.25.9", folder_ / "noise"}), Verdict::refused);
    EXPECT_EQ(*receive(*receiver, {"2.25.9", files[0].file}), Verdict::refused) << "another name";
    const auto path = write("../../escape");
    EXPECT_EQ(*receive(*receiver, path[0]), Verdict::refused);
    EXPECT_EQ(studies->unreadable(), 3u);
    EXPECT_TRUE(studies->finishAll().empty());
    EXPECT_TRUE(spool.entries().empty());
    EXPECT_EQ(arriving(), 0u);
    const auto dropped = *receiver->place();
    receiver->drop(dropped);
    EXPECT_FALSE(fs::exists(dropped));
}

TEST_F(ReceivedStudiesTest, AStudyIsDoneWhenItIsQuietAndGoesOnLater) {
    Spool spool = openSpool();
    const auto studies = into(spool, {.quiet = std::chrono::hours(1)});
    const auto files = write("2.25.1");
    const auto receiver = studies->receiverFor({.ae = "CT1", .address = {}});
    ASSERT_TRUE(receive(*receiver, files[0]));
    EXPECT_TRUE(studies->finishQuiet().empty()) << "more may come";
    const auto hasty = into(spool, {.quiet = {}});
    EXPECT_FALSE(receive(*hasty->receiverFor({.ae = "CT1", .address = {}}), files[1])) << "it is locked";
    ASSERT_TRUE(hasty->takeTrouble());
    EXPECT_FALSE(hasty->takeTrouble());
    EXPECT_TRUE(hasty->finishAll().empty());
    ASSERT_EQ(studies->finishAll().size(), 1u);
    ASSERT_TRUE(receive(*hasty->receiverFor({.ae = "CT1", .address = {}}), files[1]));
    const auto done = hasty->finishQuiet();
    ASSERT_EQ(done.size(), 1u);
    EXPECT_EQ(done[0].kept, 1u);
    EXPECT_EQ(done[0].instances, 2u);
}

TEST_F(ReceivedStudiesTest, StudiesWithoutEndAreBounded) {
    Spool spool = openSpool();
    const auto studies =
        into(spool, {.quiet = std::chrono::hours(1), .mostStudies = 4, .mostStudiesAtOnce = 2});
    const auto receiver = studies->receiverFor({.ae = "CT1", .address = {}});
    for (int i = 1; i <= 4; ++i) ASSERT_TRUE(receive(*receiver, write("2.25.1" + std::to_string(i))[0]));
    EXPECT_EQ(studies->finishQuiet().size(), 2u) << "those that were quiet longest, when others came";
    EXPECT_FALSE(receive(*receiver, write("2.25.15")[0]));
    EXPECT_TRUE(studies->takeTrouble());
    EXPECT_EQ(studies->finishAll().size(), 2u);
    EXPECT_EQ(spool.entries().size(), 4u);
}

TEST_F(ReceivedStudiesTest, OnlyNewStudiesOfLateCount) {
    Spool spool = openSpool();
    const auto studies = into(spool, {.mostStudies = 2});
    const auto receiver = studies->receiverFor({.ae = "CT1", .address = {}});
    const auto first = write("2.25.11");
    ASSERT_TRUE(receive(*receiver, first[0]));
    ASSERT_TRUE(receive(*receiver, write("2.25.12")[0]));
    ASSERT_EQ(studies->finishAll().size(), 2u);
    EXPECT_FALSE(receive(*receiver, write("2.25.13")[0])) << "those that are done count too";
    EXPECT_FALSE(fs::exists(spool.folderOf("2.25.13")));
    EXPECT_TRUE(receive(*receiver, first[1])) << "more of one that is there";
    studies->finishAll();

    const auto forgetful = into(spool, {.mostStudies = 2, .counted = {}});
    const auto patient = forgetful->receiverFor({.ae = "CT1", .address = {}});
    for (int i = 3; i <= 9; ++i) {
        ASSERT_TRUE(receive(*patient, write("2.25.1" + std::to_string(i))[0])) << "the others are long ago";
        forgetful->finishAll();
    }
}

TEST_F(ReceivedStudiesTest, SaysWhatIsOnItsWayAndOfWhomItWas) {
    Spool spool = openSpool();
    const auto studies = into(spool);
    const auto receiver = studies->receiverFor({.ae = "CT1", .address = {}});
    EXPECT_EQ(studies->arriving(), ArrivingStudies{});
    const auto files = write("2.25.1");
    ASSERT_TRUE(receive(*receiver, files[0]));
    ASSERT_TRUE(receive(*receiver, files[1]));
    ASSERT_TRUE(receive(*receiver, files[1]));
    ASSERT_TRUE(receive(*receiver, write("2.25.2")[0]));
    EXPECT_EQ(studies->arriving(), (ArrivingStudies{.studies = 2, .images = 3}));
    auto done = studies->finishAll();
    EXPECT_EQ(studies->arriving(), ArrivingStudies{});
    ASSERT_EQ(done.size(), 2u);
    std::ranges::sort(done, {}, &ReceivedStudy::kept);
    EXPECT_EQ(done[1].identity.patientId, "SYN1");
    EXPECT_EQ(done[1].identity.studyInstanceUid, "2.25.1");
    EXPECT_EQ(done[1].modalities, std::set<std::string>{"CT"});
}

TEST_F(ReceivedStudiesTest, AFullDiskIsSaidBeforeAnythingIsWritten) {
    Spool spool = openSpool({.leastFreeBytes = std::uintmax_t(1) << 60});
    const auto studies = into(spool);
    const auto receiver = studies->receiverFor({.ae = "CT1", .address = {}});
    EXPECT_EQ(receiver->mostBytesOfInstance(), 0u);
    EXPECT_FALSE(receive(*receiver, write("2.25.1")[0]));
    EXPECT_EQ(studies->takeTrouble()->code, ErrorCode::outputNotWritable);
    EXPECT_EQ(arriving(), 0u);
}

TEST_F(ReceivedStudiesTest, SeveralSendersAtOnceWhileStudiesAreFinished) {
    Spool spool = openSpool({.patience = std::chrono::seconds(60), .leastFreeBytes = 0});
    const auto studies = into(spool, {.quiet = {}});
    std::vector<std::vector<Sent>> all;
    for (int i = 1; i <= 3; ++i) all.push_back(write("2.25.1" + std::to_string(i)));
    std::atomic<bool> ends{false};
    std::size_t kept = 0;
    std::thread finisher([&] {
        while (!ends.load())
            for (const ReceivedStudy& each : studies->finishQuiet()) kept += each.kept;
    });
    std::vector<std::thread> senders;
    for (int t = 0; t < 4; ++t) {
        senders.emplace_back([&] {
            const auto receiver = studies->receiverFor({.ae = "CT1", .address = {}});
            for (const auto& files : all)
                for (const Sent& each : files) {
                    const auto verdict = receive(*receiver, each);
                    EXPECT_TRUE(verdict) << (verdict ? Text() : verdict.error().message);
                }
        });
    }
    for (std::thread& sender : senders) sender.join();
    ends = true;
    finisher.join();
    for (const ReceivedStudy& each : studies->finishAll()) kept += each.kept;
    EXPECT_EQ(kept, 9u) << "each was kept once";
    ASSERT_EQ(spool.entries().size(), 3u);
    for (const SpoolEntry& entry : spool.entries()) EXPECT_EQ(entry.instances, 3u);
    EXPECT_EQ(arriving(), 0u);
}

// A process that receives two studies without end is killed at a random moment; the spool opens, and all it
// holds is whole and where it belongs.
TEST_F(ReceivedStudiesTest, KilledAtAnyMomentTheSpoolOpens) {
    const std::vector<std::vector<Sent>> sent{write("2.25.1"), write("2.25.2")};
    std::mt19937 random(11);
    for (int round = 0; round < 60; ++round) {
        const pid_t child = fork();
        if (child == 0) {
            auto spool = Spool::open(folder_ / "spool", {.leastFreeBytes = 0});
            auto studies = spool ? ReceivedStudies::into(*spool, {.quiet = {}}) : Error{};
            if (!studies) _exit(1);
            const auto receiver = (*studies)->receiverFor({.ae = "CT1", .address = {}});
            for (std::size_t i = 0;; ++i) {
                for (const auto& files : sent)
                    if (!receive(*receiver, files[i % files.size()])) _exit(2);
                if (i % 4 == 0) (*studies)->finishQuiet();
            }
        }
        usleep(std::uniform_int_distribution<useconds_t>(0, 30'000)(random));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself: " << status;

        Spool spool = openSpool();
        const auto studies = into(spool);
        EXPECT_EQ(arriving(), 0u);
        for (std::size_t i = 0; i < sent.size(); ++i) {
            const auto study = spool.study(i == 0 ? "2.25.1" : "2.25.2");
            ASSERT_TRUE(study);
            for (const auto& entry : fs::directory_iterator((*study)->folder())) {
                const std::string bytes = bytesOf(entry.path());
                EXPECT_TRUE(std::ranges::any_of(sent[i], [&](const Sent& each) {
                    return bytesOf(each.file) == bytes;
                })) << "a part of a file, or of the other study";
            }
            if (round % 7 == 0) fs::remove_all((*study)->folder());
        }
    }
}

}  // namespace

}  // namespace macula::study
