// Where nothing, or not enough, can be written: what was there stays, and the exit code says it.
#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>

#include "cli/run_command.h"
#include "session/store.h"
#include "session/support.h"

namespace macula::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDot =
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
    "property float f_dc_0\nproperty float f_dc_1\nproperty float f_dc_2\nproperty float opacity\n"
    "property float scale_0\nproperty float scale_1\nproperty float scale_2\nproperty float rot_0\n"
    "property float rot_1\nproperty float rot_2\nproperty float rot_3\nend_header\n"
    "0 0 3 1 1 1 20 -1 -1 -1 1 0 0 0\n";

// Each writes `output` and nothing else, small but for the volumes.
struct Writer {
    std::string output;
    std::vector<std::string> arguments;  // OUT stands for the output, DIR for its folder, IN for inputs
};

const std::vector<Writer> kWriters{
    {"a.png", {"render", "IN/ball.nrrd", "-o", "OUT", "--size", "200x200", "--spp", "1"}},
    {"a.exr", {"render", "IN/ball.nrrd", "-o", "OUT", "--size", "200x200", "--spp", "1"}},
    {"a.json",
     {"render", "IN/ball.nrrd", "-o", "IN/a.png", "--size", "16x16", "--spp", "1", "--json", "OUT"}},
    {"a.nii", {"export", "IN/ball.nrrd", "-o", "OUT"}},
    {"a.nii.gz", {"export", "IN/ball.nrrd", "-o", "OUT"}},
    {"a.nrrd", {"export", "IN/ball.nrrd", "-o", "OUT"}},
    {"a.nhdr", {"export", "IN/ball.nrrd", "-o", "OUT"}},
    {"a.mha", {"export", "IN/ball.nrrd", "-o", "OUT"}},
    {"a.mhd", {"export", "IN/ball.nrrd", "-o", "OUT"}},
    {"a.stl", {"segment", "IN/ball.nrrd", "-o", "OUT", "--threshold", "50", "100000"}},
    {"a.json", {"presets", "export", "ct-bone", "-o", "OUT"}},
    {"a.json", {"presets", "import", "IN/preset.json", "-o", "OUT"}},
    {"dot.png", {"splat-render", "IN/dot.ply", "-o", "DIR", "--camera", "IN/dot.json", "--size", "64x64"}},
    // Of points alone, the quickest; what is written is as large.
    {"a.ply",
     {"train", "IN/ball.nrrd", "-o", "OUT", "--points", "300", "--views", "0", "--directions", "0",
      "--iterations", "0"}},
    {"a.macula",
     {"train", "IN/ball.nrrd", "-o", "OUT", "--size", "32", "--views", "3", "--spp", "1", "--points", "300",
      "--iterations", "4", "--directions", "5"}},
    {"a.png", {"sheet", "IN/ball.nrrd", "-o", "OUT", "--tile", "16", "--spp", "1"}},
};

class FullDisk : public CommandTest {
  protected:
    void SetUp() override {
        CommandTest::SetUp();
        fs::create_directories(at("in"));
        fs::create_directories(at("disk"));
        write("in/dot.ply", kDot);
        writeBall("in/ball.nrrd");
        write("in/dot.json",
              R"({"positionMm": [0, 0, 0], "targetMm": [0, 0, 3], "up": [0, 1, 0], "verticalFovDeg": 30})");
        ASSERT_EQ(runMacula({"presets", "export", "ct-bone", "-o", at("in/preset.json")}).exitCode, 0);
    }
    void TearDown() override {
        if (mounted_) umount2(at("disk").c_str(), MNT_DETACH);
        CommandTest::TearDown();
    }
    // A disk of its own, seen by this process and its children alone. False where that is not allowed.
    bool mountDisk(const std::string& size) {
        if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0)
            return false;
        mounted_ = mount("tmpfs", at("disk").c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
        return mounted_;
    }
    // Leaves so many bytes free.
    void fill(std::size_t free) const {
        const std::string path = at("disk/filler");
        const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
        const std::string block(4096, 'x');
        while (::write(file, block.data(), block.size()) == static_cast<ssize_t>(block.size())) {
        }
        const off_t size = lseek(file, 0, SEEK_END);
        ASSERT_EQ(ftruncate(file, std::max<off_t>(size - static_cast<off_t>(free), 0)), 0);
        close(file);
    }
    std::vector<std::string> wordsOf(const Writer& writer) const {
        std::vector<std::string> words = writer.arguments;
        for (std::string& word : words) {
            if (word == "OUT") word = at("disk/" + writer.output);
            if (word == "DIR") word = at("disk");
            if (word.starts_with("IN/")) word = at("in/" + word.substr(3));
        }
        words.emplace_back("--overwrite");
        return words;
    }
    std::map<std::string, std::string> contents() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::directory_iterator(at("disk")))
            all[entry.path().filename().string()] = readAll(entry.path());
        return all;
    }
    void expectLeftAlone(const Writer& writer) const {
        const auto words = wordsOf(writer);
        const auto before = contents();
        const Ran ran = runMacula(words);
        const std::string call = fmt::format("{}", fmt::join(words, " "));
        EXPECT_EQ(ran.exitCode, 2) << call << "\n" << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << call << "\n" << ran.err;
        EXPECT_EQ(contents(), before) << call;
    }

    bool mounted_ = false;
};

TEST_F(FullDisk, LeavesWhatWasThere) {
    if (!mountDisk("100k")) GTEST_SKIP() << "no right to mount";
    for (const Writer& writer : kWriters) {
        write("disk/" + writer.output, "a good one");
        if (writer.output.ends_with("hd") || writer.output.ends_with("hdr"))
            write("disk/a.raw", "its values");
        fill(0);
        expectLeftAlone(writer);
        for (const auto& entry : fs::directory_iterator(at("disk"))) fs::remove_all(entry.path());
    }
}

// Some of it finds room: a part is as bad as nothing.
TEST_F(FullDisk, AlmostEnoughRoomIsNotEnough) {
    if (!mountDisk("400k")) GTEST_SKIP() << "no right to mount";
    for (const Writer& writer : kWriters) {
        if (writer.arguments.front() == "sheet") continue;  // long, and written as other pictures are
        const std::string name = "disk/" + writer.output;
        const Ran whole = runMacula(wordsOf(writer));
        ASSERT_EQ(whole.exitCode, 0) << name << whole.err;
        std::size_t needed = 0;
        for (const auto& [file, content] : contents()) needed += content.size();
        for (const std::size_t missing : {std::size_t{1}, needed / 2}) {
            for (const auto& entry : fs::directory_iterator(at("disk"))) fs::remove_all(entry.path());
            write(name, "a good one");
            if (needed <= 8192) break;  // nothing between all and nothing on pages
            if (missing > 1 && writer.arguments.front() != "export") break;  // one will do of what takes long
            fill((needed - missing) / 4096 * 4096);
            expectLeftAlone(writer);
        }
        for (const auto& entry : fs::directory_iterator(at("disk"))) fs::remove_all(entry.path());
    }
}

TEST_F(FullDisk, AReadOnlyFolderIsTold) {
    if (!mountDisk("100k")) GTEST_SKIP() << "no right to mount";
    for (const Writer& writer : kWriters) write("disk/" + writer.output, "a good one");
    ASSERT_EQ(mount(nullptr, at("disk").c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr), 0);
    for (const Writer& writer : kWriters) expectLeftAlone(writer);
    EXPECT_EQ(runMacula({"phantom", at("disk/study")}).exitCode, 2);
}

TEST_F(FullDisk, ThePhantomIsWrittenWholeOrNotAtAll) {
    if (!mountDisk("100k")) GTEST_SKIP() << "no right to mount";
    const Ran ran = runMacula({"phantom", at("disk/study")});
    EXPECT_EQ(ran.exitCode, 2) << ran.err;
    EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
    EXPECT_TRUE(contents().empty());
}

TEST_F(FullDisk, StoredStudiesAreExportedWholeOrNotAtAll) {
    if (!mountDisk("300k")) GTEST_SKIP() << "no right to mount";
    const session::StoreOptions options{.folder = at("in/store")};
    ASSERT_TRUE(session::test::isOk(
        session::test::valueOf(session::Store::open(options))
            .saveModel(session::test::keyOf("chest"), session::test::blobOf(1, 250'000))));
    const Ran ran = runMacula({"sessions", "export", at("disk/out"), "--folder", at("in/store")});
    EXPECT_EQ(ran.exitCode, 2) << ran.err;
    EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
    EXPECT_NE(ran.err.find("the disk is full"), std::string::npos) << ran.err;
    EXPECT_TRUE(fs::is_empty(at("disk")));
}

TEST_F(FullDisk, StoredStudiesOfAReadOnlyDiskAreToldToBe) {
    if (!mountDisk("1m")) GTEST_SKIP() << "no right to mount";
    const session::StoreOptions options{.folder = at("disk/store")};
    ASSERT_TRUE(session::test::isOk(session::Store::open(options)));
    ASSERT_EQ(mount(nullptr, at("disk").c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr), 0);
    for (const std::string verb : {"list", "verify", "gc", "audit"}) {
        const Ran ran = runMacula({"sessions", verb, "--folder", at("disk/store")});
        EXPECT_EQ(ran.exitCode, 2) << verb << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find("read-only"), std::string::npos) << ran.err;
    }
}

// Needs no rights: no file may grow beyond that.
TEST_F(FullDisk, AFileThatMayNotGrowIsNotPutInPlace) {
    for (const Writer& writer : kWriters) {
        if (writer.output.ends_with(".json")) continue;     // shorter
        if (writer.arguments.front() == "sheet") continue;  // as above
        write("disk/" + writer.output, "a good one");
        const auto before = contents();
        const Ran ran = runMacula(wordsOf(writer), {}, [] {
            std::signal(SIGXFSZ, SIG_IGN);
            const rlimit most{1000, 1000};
            setrlimit(RLIMIT_FSIZE, &most);
        });
        EXPECT_EQ(ran.exitCode, 2) << writer.arguments.front() << writer.output << ran.err;
        EXPECT_EQ(contents(), before) << writer.arguments.front() << writer.output;
    }
}

TEST_F(FullDisk, StandardOutputThatTakesNothingIsTold) {
    const auto full = [] {
        const int device = open("/dev/full", O_WRONLY);
        dup2(device, STDOUT_FILENO);
    };
    const auto closed = [] { close(STDOUT_FILENO); };
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"presets"},
             {"presets", "--json"},
             {"devices"},
             {"--help"},
             {"render", "-o", at("a.png"), "--size", "16x16", "--spp", "1", "--json", "-", "--overwrite"}}) {
        for (const auto& prepare : {std::function<void()>(full), std::function<void()>(closed)}) {
            const Ran ran = runMacula(arguments, {}, prepare);
            EXPECT_EQ(ran.exitCode, 2) << arguments.front() << ran.err;
            EXPECT_EQ(ran.errorLines(), 1u) << arguments.front() << ran.err;
        }
    }
}

TEST_F(FullDisk, AStandardErrorThatTakesNothingChangesNothing) {
    const auto full = [] {
        const int device = open("/dev/full", O_WRONLY);
        dup2(device, STDERR_FILENO);
    };
    const auto closed = [] { close(STDERR_FILENO); };
    const std::vector<std::string> arguments{"render", "-o", at("a.png"),  "--size", "16x16",
                                             "--spp",  "1",  "--overwrite"};  // has a note to tell
    ASSERT_EQ(runMacula(arguments).exitCode, 0);
    const std::string picture = readAll(at("a.png"));
    for (const auto& prepare : {std::function<void()>(full), std::function<void()>(closed)}) {
        EXPECT_EQ(runMacula(arguments, {"MACULA_LOG=info"}, prepare).exitCode, 0);
        EXPECT_EQ(readAll(at("a.png")), picture) << "what was told went into the picture";
        EXPECT_EQ(runMacula({"info", at("nowhere")}, {}, prepare).exitCode, 3);
    }
}

}  // namespace
}  // namespace macula::cli
