// What is in an archive comes out of it, into a private folder that goes.
#include "unpack/unpacked_archive.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/sha256.h"
#include "dicom/support.h"
#include "unpack/archive_name.h"
#include "unpack/made_archive.h"

namespace macula::unpack {
namespace {

namespace fs = std::filesystem;
using dicom::test::TemporaryFolder;
using test::Format;
using test::Member;

constexpr std::array kFormats{Format::zip, Format::tar, Format::gzippedTar, Format::xzTar, Format::iso};

std::shared_ptr<const UnpackedArchive> unpacked(const fs::path& file, const UnpackLimits& limits = {}) {
    Progress progress;
    const auto made = unpack(file, progress, limits);
    EXPECT_TRUE(made) << made.error().message;
    return made ? *made : nullptr;
}

std::map<std::string, std::string> contentOf(const fs::path& folder) {
    std::map<std::string, std::string> found;
    for (const fs::directory_entry& each : fs::recursive_directory_iterator(folder))
        if (each.is_regular_file())
            found[each.path().lexically_relative(folder).string()] = test::bytesOf(each.path());
    return found;
}

std::size_t copies() {
    std::error_code none;
    return std::size_t(
        std::distance(fs::directory_iterator(unpackedFolder(), none), fs::directory_iterator()));
}

// Repeatable bytes that do not compress.
std::string noise(std::size_t bytes, unsigned seed) {
    std::string made(bytes, '\0');
    for (char& c : made) c = static_cast<char>((seed = seed * 1664525u + 1013904223u) >> 24);
    return made;
}

TEST(UnpackedArchive, HoldsWhatTheArchiveHolds) {
    const TemporaryFolder folder;
    const std::map<std::string, std::string> content{{"DICOMDIR", "directory"},
                                                     {"DICOM/PAT1/IM0001", noise(700'000, 1)},
                                                     {"DICOM/PAT1/IM0002", noise(1, 2)},
                                                     {"DICOM/PAT2/IM0001", ""}};
    std::vector<Member> members;
    for (const auto& [name, bytes] : content) members.push_back({.name = name, .content = bytes});
    for (const Format format : kFormats) {
        const fs::path file = folder / ("study" + endingOf(format));
        writeArchive(file, format, members);
        EXPECT_TRUE(isArchive(file)) << file;
        const auto made = unpacked(file);
        ASSERT_TRUE(made) << file;
        EXPECT_EQ(contentOf(made->folder()), content) << file;
        EXPECT_EQ(made->facts().files, content.size()) << file;
        EXPECT_FALSE(made->facts().isCutOff) << file;
        EXPECT_EQ(made->facts().damaged + made->facts().encrypted + made->facts().links, 0u) << file;
    }
}

// Content decides, not the name.
TEST(UnpackedArchive, IsRecognisedByItsContent) {
    const TemporaryFolder folder;
    for (const Format format : kFormats) {
        writeArchive(folder / "download", format, std::vector<Member>{{.name = "a", .content = "b"}});
        EXPECT_TRUE(isArchive(folder / "download")) << endingOf(format);
    }
    test::writeBytes(folder / "image.zip", std::string(128, '\0') + "DICM and the rest");
    EXPECT_FALSE(isArchive(folder / "image.zip"));
    test::writeBytes(folder / "image", "any bytes");
    EXPECT_FALSE(isArchive(folder / "image"));
    EXPECT_FALSE(isArchive(folder.path()));
    EXPECT_FALSE(isArchive(folder / "nothing.zip"));
    test::writeBytes(folder / "pretends.iso", "any bytes");
    EXPECT_TRUE(isArchive(folder / "pretends.iso"));
}

TEST(UnpackedArchive, IsPrivateAndGoes) {
    const TemporaryFolder folder;
    writeArchive(folder / "a.zip", Format::zip, std::vector<Member>{{.name = "b/c", .content = "d"}});
    const std::size_t before = copies();
    auto made = unpacked(folder / "a.zip");
    ASSERT_TRUE(made);
    struct stat found {};
    for (const fs::path& each : {unpackedFolder(), made->folder()}) {
        ASSERT_EQ(stat(each.c_str(), &found), 0);
        EXPECT_EQ(found.st_mode & 0777u, 0700u) << each;
    }
    ASSERT_EQ(stat((made->folder() / "b/c").c_str(), &found), 0);
    EXPECT_EQ(found.st_mode & 0777u, 0600u);
    EXPECT_EQ(copies(), before + 1);
    const auto shared = made;
    made.reset();
    EXPECT_EQ(copies(), before + 1);
}

TEST(UnpackedArchive, OfAKilledProgramGoesWithTheNext) {
    const TemporaryFolder folder;
    writeArchive(folder / "a.zip", Format::zip, std::vector<Member>{{.name = "b", .content = "d"}});
    const auto inUse = unpacked(folder / "a.zip");
    const fs::path left = unpackedFolder() / ".archive.0123456789abcdef.part";
    fs::create_directories(left / "DICOM");
    test::writeBytes(left / "DICOM/IM1", "of a patient");
    removeAbandoned();
    EXPECT_FALSE(fs::exists(left));
    ASSERT_TRUE(inUse);
    EXPECT_TRUE(fs::exists(inUse->folder() / "b"));
}

TEST(UnpackedArchive, LeavesNothingWhenItIsCancelled) {
    const TemporaryFolder folder;
    std::vector<Member> members;
    for (unsigned i = 0; i < 20; ++i)
        members.push_back({.name = "im" + std::to_string(i), .content = noise(1u << 20, i)});
    writeArchive(folder / "a.tar.gz", Format::gzippedTar, members);
    const std::size_t before = copies();
    const CancelToken token;
    Progress progress(
        [&](const ProgressUpdate& update) {
            EXPECT_EQ(update.stage, "Unpacking the archive");
            if (update.fraction > 0.0) token.cancel();
        },
        token);
    const auto made = unpack(folder / "a.tar.gz", progress);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::cancelled);
    EXPECT_EQ(copies(), before);
}

TEST(UnpackedArchive, LeavesNothingOnAFullDisk) {
    const TemporaryFolder folder;
    writeArchive(folder / "a.zip", Format::zip, std::vector<Member>{{.name = "b", .content = "d"}});
    const std::size_t before = copies();
    Progress progress;
    const auto made = unpack(folder / "a.zip", progress, {.leastFreeBytes = ~std::uintmax_t(0)});
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::outputNotWritable);
    EXPECT_EQ(made.error().message,
              "The disk has too little space to unpack the archive, and nothing of it was kept.");
    EXPECT_EQ(copies(), before);
}

// Two files that are the same are stored once, the second as a hard link.
TEST(UnpackedArchive, HoldsFilesThatAreTheSameUnderEachName) {
    const TemporaryFolder folder;
    writeArchive(folder / "a.tar", Format::tar,
                 {{.name = "IM1", .content = "same"},
                  {.name = "b/IM2", .kind = Member::Kind::hardLink, .target = "IM1"}});
    const auto made = unpacked(folder / "a.tar");
    ASSERT_TRUE(made);
    EXPECT_EQ(contentOf(made->folder()),
              (std::map<std::string, std::string>{{"IM1", "same"}, {"b/IM2", "same"}}));
}

// The files of ../shared/data/planar/6_containers, whose digests are known.
TEST(UnpackedArchive, HoldsTheFilesOfRealArchives) {
    SKIP_WITHOUT_SHARED_DATA();
    const fs::path data = dicom::test::sharedData() / "planar";
    if (!fs::exists(data / "6_containers")) GTEST_SKIP() << "no archives in the test data";
    std::ifstream truth(data / "truth/6_containers.json");
    const auto archives = nlohmann::json::parse(truth);
    std::size_t compared = 0;
    for (const auto& [name, about] : archives.items()) {
        const char* const list = about.contains("files") ? "files" : "members";
        if (!about.contains(list) || !fs::exists(data / name)) continue;
        const auto made = unpacked(data / name);
        ASSERT_TRUE(made) << name;
        std::multiset<std::string> wanted;
        std::multiset<std::string> found;
        for (const auto& file : about[list]) {
            if (file["dicom"].get<bool>()) wanted.insert(file["sha256"].get<std::string>());
        }
        for (const auto& [path, bytes] : contentOf(made->folder())) {
            const std::string digest = sha256Hex(bytes);
            if (wanted.contains(digest)) found.insert(digest);
        }
        EXPECT_EQ(found, wanted) << name;
        EXPECT_FALSE(made->facts().isCutOff) << name;
        ++compared;
    }
    EXPECT_EQ(compared, 2u);
}

}  // namespace
}  // namespace macula::unpack
