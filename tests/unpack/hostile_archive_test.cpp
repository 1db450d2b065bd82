// Archives that are broken, or made to do harm.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "dicom/support.h"
#include "unpack/made_archive.h"
#include "unpack/unpacked_archive.h"

namespace macula::unpack {
namespace {

namespace fs = std::filesystem;
using dicom::test::TemporaryFolder;
using test::Format;
using test::Member;
using Made = Result<std::shared_ptr<const UnpackedArchive>>;

Made unpacked(const fs::path& file, const UnpackLimits& limits = {}) {
    Progress progress;
    return unpack(file, progress, limits);
}

std::vector<fs::path> entriesIn(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code none;
    for (const fs::directory_entry& each : fs::recursive_directory_iterator(folder, none))
        found.push_back(each.path());
    return found;
}

// The content of all files, whatever they are called; nothing else is there but folders.
std::vector<std::string> contentOf(const fs::path& folder) {
    std::vector<std::string> found;
    for (const fs::path& each : entriesIn(folder)) {
        EXPECT_FALSE(fs::is_symlink(each)) << each;
        if (fs::is_directory(each)) continue;
        EXPECT_TRUE(fs::is_regular_file(each)) << each;
        found.push_back(test::bytesOf(each));
    }
    std::ranges::sort(found);
    return found;
}

std::string noise(std::size_t bytes, unsigned seed) {
    std::string made(bytes, '\0');
    for (char& c : made) c = static_cast<char>((seed = seed * 1664525u + 1013904223u) >> 24);
    return made;
}

class HostileArchive : public testing::Test {
  protected:
    void SetUp() override { before_ = entriesIn(unpackedFolder()).size(); }

    void expectRefused(const fs::path& file, std::string_view sentence, const UnpackLimits& limits = {}) {
        const Made made = unpacked(file, limits);
        ASSERT_FALSE(made) << file;
        EXPECT_EQ(made.error().code, ErrorCode::inputNotUsable);
        EXPECT_NE(made.error().message.english().find(sentence), std::string::npos) << made.error().message;
        EXPECT_FALSE(made.error().hint.empty());
        EXPECT_EQ(made.error().where, file.string());
        EXPECT_EQ(entriesIn(unpackedFolder()).size(), before_) << "something was left";
    }

    TemporaryFolder folder_;
    std::size_t before_ = 0;
};

TEST_F(HostileArchive, WritesNothingOutside) {
    const std::string deep = [] {
        std::string made;
        for (int i = 0; i < 200; ++i) made += "d/";
        return made + "x";
    }();
    const std::vector<Member> members{{.name = "../../../../../../tmp/macula-hostile", .content = "1"},
                                      {.name = "/tmp/macula-hostile", .content = "2"},
                                      {.name = "a/../../macula-hostile", .content = "3"},
                                      {.name = "b\nc\x1b[2J", .content = "4"},
                                      {.name = std::string(3000, 'n'), .content = "5"},
                                      {.name = deep, .content = "6"},
                                      {.name = "x", .content = "7"},
                                      {.name = "x", .content = "8"},     // the same name
                                      {.name = "x/y", .content = "9"}};  // a file as a folder
    for (const Format format : {Format::zip, Format::tar, Format::gzippedTar}) {
        const fs::path file = folder_ / ("a" + endingOf(format));
        writeArchive(file, format, members);
        const Made made = unpacked(file);
        ASSERT_TRUE(made) << made.error().message;
        EXPECT_EQ(contentOf((*made)->folder()),
                  (std::vector<std::string>{"1", "2", "3", "4", "5", "6", "7", "8", "9"}))
            << file;
        EXPECT_EQ((*made)->facts().outside, 3u);
        EXPECT_FALSE(fs::exists("/tmp/macula-hostile"));
    }
}

TEST_F(HostileArchive, FollowsNoLinksAndMakesNoDevices) {
    writeArchive(folder_ / "a.tar", Format::tar,
                 {{.name = "out", .kind = Member::Kind::symbolicLink, .target = folder_.path().string()},
                  {.name = "out/written", .content = "1"},
                  {.name = "passwd", .kind = Member::Kind::hardLink, .target = "/etc/passwd"},
                  {.name = "up", .kind = Member::Kind::hardLink, .target = "../../../../etc/passwd"},
                  {.name = "null", .kind = Member::Kind::device},
                  {.name = "pipe", .kind = Member::Kind::pipe}});
    const Made made = unpacked(folder_ / "a.tar");
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(contentOf((*made)->folder()), (std::vector<std::string>{"1"}));
    EXPECT_EQ((*made)->facts().links, 5u);
    EXPECT_FALSE(fs::exists(folder_ / "written"));
    writeArchive(folder_ / "a.zip", Format::zip,
                 {{.name = "out", .kind = Member::Kind::symbolicLink, .target = "/etc"},
                  {.name = "out/written", .content = "1"}});
    const Made zip = unpacked(folder_ / "a.zip");
    ASSERT_TRUE(zip) << zip.error().message;
    EXPECT_EQ(contentOf((*zip)->folder()), (std::vector<std::string>{"1"}));
    EXPECT_EQ((*zip)->facts().links, 1u);
}

TEST_F(HostileArchive, RefusesBombs) {
    const UnpackLimits limits{.fileBytesInAnyCase = 8u << 20};
    const std::string zeros(64u << 20, '\0');
    for (const Format format : {Format::zip, Format::xzTar}) {
        const fs::path file = folder_ / ("bomb" + endingOf(format));
        writeArchive(file, format, std::vector<Member>{{.name = "a", .content = zeros}});
        expectRefused(file, "hundreds of times", limits);
    }
    // Many files, each of which is harmless.
    std::vector<Member> many;
    for (int i = 0; i < 64; ++i)
        many.push_back({.name = std::to_string(i), .content = zeros.substr(0, 1u << 20)});
    writeArchive(folder_ / "many.tar.xz", Format::xzTar, many);
    expectRefused(folder_ / "many.tar.xz", "hundreds of times", {.bytesInAnyCase = 8u << 20});
    EXPECT_TRUE(unpacked(folder_ / "many.tar.xz"));  // 64 MB fill no disk
    expectRefused(folder_ / "many.tar.xz", "unpacks to more than", {.mostBytes = 32u << 20});
    expectRefused(folder_ / "many.tar.xz", "unpacks to more than", {.mostBytesOfFile = 1u << 19});
    // A hole has a size and no content.
    writeArchive(folder_ / "hole.tar", Format::tar,
                 std::vector<Member>{{.name = "a", .content = "end", .holeBytes = 64ll << 20}});
    ASSERT_LT(fs::file_size(folder_ / "hole.tar"), 1u << 20);
    expectRefused(folder_ / "hole.tar", "hundreds of times", limits);
}

TEST_F(HostileArchive, RefusesMoreFilesThanAnyStudyHas) {
    std::vector<Member> members;
    for (int i = 0; i < 1001; ++i) members.push_back({.name = std::to_string(i), .content = "1"});
    writeArchive(folder_ / "a.zip", Format::zip, members);
    expectRefused(folder_ / "a.zip", "more than 1000 files", {.mostEntries = 1000});
    members.clear();
    for (int i = 0; i < 100'000; ++i)
        members.push_back({.name = std::to_string(i / 1000) + "/" + std::to_string(i), .content = "1"});
    writeArchive(folder_ / "many.zip", Format::zip, members);
    const Made made = unpacked(folder_ / "many.zip");
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ((*made)->facts().files, 100'000u);
}

TEST_F(HostileArchive, LeavesEncryptedFilesOut) {
    const std::vector<Member> members{{.name = "IM1", .content = "first"},
                                      {.name = "IM2", .content = "second"},
                                      {.name = "IM3", .content = "third"}};
    writeArchive(folder_ / "all.zip", Format::encryptedZip, members);
    expectRefused(folder_ / "all.zip", "The archive is encrypted");
    writeArchive(folder_ / "one.zip", Format::zip, members);
    test::markEncrypted(folder_ / "one.zip", "IM2");
    const Made made = unpacked(folder_ / "one.zip");
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(contentOf((*made)->folder()), (std::vector<std::string>{"first", "third"}));
    EXPECT_EQ((*made)->facts().encrypted, 1u);
}

TEST_F(HostileArchive, KeepsWhatCameBeforeACut) {
    std::vector<Member> members;
    for (unsigned i = 0; i < 10; ++i)
        members.push_back({.name = "IM" + std::to_string(i), .content = noise(100'000, i)});
    for (const Format format : {Format::zip, Format::tar, Format::gzippedTar, Format::xzTar, Format::iso}) {
        const fs::path file = folder_ / ("a" + endingOf(format));
        writeArchive(file, format, members);
        fs::resize_file(file, fs::file_size(file) * 6 / 10);
        const Made made = unpacked(file);
        // An xz file has one block, whose beginning can be read.
        ASSERT_TRUE(made) << file << ": " << made.error().message;
        EXPECT_TRUE((*made)->facts().isCutOff) << file;
        EXPECT_GE((*made)->facts().files, 3u) << file;
        EXPECT_LT((*made)->facts().files, members.size()) << file;
        for (const std::string& content : contentOf((*made)->folder())) {
            EXPECT_TRUE(std::ranges::any_of(members, [&](const Member& m) { return m.content == content; }))
                << file << ": a part of a file was kept";
        }
    }
    // Between two files.
    const fs::path file = folder_ / "between.tar";
    writeArchive(file, Format::tar, members);
    constexpr std::uintmax_t kEntry = 512 + 100'352;
    fs::resize_file(file, 5 * kEntry);
    const Made made = unpacked(file);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ((*made)->facts().files, 5u);
    EXPECT_TRUE((*made)->facts().isCutOff);
}

TEST_F(HostileArchive, LeavesDamagedFilesOut) {
    writeArchive(
        folder_ / "a.zip", Format::zip,
        {{.name = "IM1", .content = noise(50'000, 1)}, {.name = "IM2", .content = noise(50'000, 2)}});
    std::string bytes = test::bytesOf(folder_ / "a.zip");
    bytes[20'000] = static_cast<char>(bytes[20'000] ^ 0x55);
    test::writeBytes(folder_ / "a.zip", bytes);
    const Made made = unpacked(folder_ / "a.zip");
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(contentOf((*made)->folder()), (std::vector<std::string>{noise(50'000, 2)}));
    EXPECT_EQ((*made)->facts().damaged, 1u);
}

TEST_F(HostileArchive, IsToldWhenItOnlyPretends) {
    test::writeBytes(folder_ / "text.zip", "This is a letter.");
    test::writeBytes(folder_ / "empty.iso", "");
    test::writeBytes(folder_ / "noise.tar.gz", noise(10'000, 3));
    test::writeBytes(folder_ / "magic.zip", "PK\x03\x04" + noise(1000, 4));
    test::writeBytes(folder_ / "other.7z", "7z\xbc\xaf\x27\x1c" + noise(1000, 5));
    test::writeBytes(folder_ / "header.gz", std::string("\x1f\x8b\x08\x00", 4) + noise(1000, 6));
    for (const char* name : {"text.zip", "empty.iso", "noise.tar.gz", "other.7z", "header.gz"})
        expectRefused(folder_ / name, "no archive that Macula can open");
    const Made magic = unpacked(folder_ / "magic.zip");
    EXPECT_FALSE(magic);
    writeArchive(folder_ / "nothing.tar", Format::tar, std::vector<Member>());
    expectRefused(folder_ / "nothing.tar", "There is no file in the archive");
}

}  // namespace
}  // namespace macula::unpack
