// An archive is read as the folder that is in it.
#include "study/open/scanned_place.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "base/paths.h"
#include "dicom/messages/messages.h"
#include "dicom/synthetic.h"
#include "study/open/found_volumes.h"
#include "study/open/loaded_study.h"
#include "study/open/opened_study.h"
#include "support.h"
#include "unpack/made_archive.h"
#include "unpack/unpacked_archive.h"

namespace macula::study {
namespace {

namespace fs = std::filesystem;
using namespace dicom::test;
using unpack::test::Format;
using unpack::test::Member;

std::size_t copies() {
    std::error_code none;
    return std::size_t(
        std::distance(fs::directory_iterator(unpack::unpackedFolder(), none), fs::directory_iterator()));
}

bool tells(const OpenedStudy& study, std::string_view words) {
    return std::ranges::any_of(study.messages, [&](const Text& message) {
        return message.english().find(words) != std::string::npos;
    });
}

class ScannedPlaceTest : public testing::Test {
  protected:
    void SetUp() override {
        write(smallVolume(), folder_ / "study/a");
        write(smallVolume(glm::dmat4(1.0), {}, "MR"), folder_ / "study/b");
    }
    fs::path archive(Format format) {
        fs::path file = folder_ / ("study" + unpack::test::endingOf(format));
        unpack::test::writeArchive(file, format, folder_ / "study");
        return file;
    }
    static Result<OpenedStudy> open(const fs::path& path) {
        Progress progress;
        return openStudy(path, progress);
    }
    TemporaryFolder folder_;
};

TEST_F(ScannedPlaceTest, AnArchiveOpensAsItsFolder) {
    const auto expected = open(folder_ / "study");
    ASSERT_TRUE(expected) << expected.error().message;
    const std::size_t before = copies();
    for (const Format format : {Format::zip, Format::tar, Format::gzippedTar, Format::xzTar, Format::iso}) {
        auto study = open(archive(format));
        ASSERT_TRUE(study) << study.error().message;
        // By which the store knows states and models again.
        EXPECT_EQ(study->seriesDigest, expected->seriesDigest);
        EXPECT_EQ(study->identity, expected->identity);
        EXPECT_EQ(study->found->key(study->volumeIndex), expected->found->key(expected->volumeIndex));
        expectSameValues(*study->measured(), *expected->measured());
        EXPECT_EQ(study->messages.size(), expected->messages.size());
        // Its other volume is read from the copy, which stays as long as that may be asked for.
        ASSERT_EQ(study->found->volumes().size(), 2u);
        Progress progress;
        EXPECT_TRUE(openFoundVolume(study->found, 1 - study->volumeIndex, progress));
        EXPECT_EQ(copies(), before + 1);
        study->found.reset();
        EXPECT_EQ(copies(), before);
    }
}

TEST_F(ScannedPlaceTest, AnArchiveIsLoadedByVerbs) {
    const std::size_t before = copies();
    Progress progress;
    const fs::path file = archive(Format::zip);
    const auto input = loadStudy(file, "2", progress);
    ASSERT_TRUE(input) << input.error().message;
    const auto expected = loadStudy(folder_ / "study", "2", progress);
    ASSERT_TRUE(expected);
    expectSameValues(*input->volume, *expected->volume);
    EXPECT_EQ(copies(), before);
    auto read = readStudy({.path = file, .series = {}, .presentation = {}, .how = {}}, true, progress);
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_TRUE(read->found);
    EXPECT_TRUE(fs::exists(read->found->volumes().front().stack->frames.front().instance->file));
    read->found.reset();
    EXPECT_EQ(copies(), before);
}

TEST_F(ScannedPlaceTest, WhatIsMissingIsSaid) {
    fs::path file = archive(Format::tar);
    fs::resize_file(file, fs::file_size(file) * 6 / 10);
    const auto cut = open(file);
    ASSERT_TRUE(cut) << cut.error().message;
    EXPECT_TRUE(tells(*cut, "The archive is cut off or damaged"));

    unpack::test::writeArchive(folder_ / "study/inner.zip", Format::zip,
                               std::vector<Member>{{.name = "IM1", .content = "1"}});
    Progress progress;
    const auto nested = scanPlace(archive(Format::zip), progress);
    ASSERT_TRUE(nested) << nested.error().message;
    EXPECT_EQ(nested->scan.archives, 1u);
    EXPECT_TRUE(std::ranges::any_of(nested->scan.messages,
                                    [](const Message& m) { return m.key == dicom::key::kArchives; }));
}

TEST_F(ScannedPlaceTest, FilesThatAreLeftOutAreNamedByTheArchive) {
    const auto files = write(smallVolume(), folder_ / "study/c");
    fs::resize_file(files.front(), fs::file_size(files.front()) - 10);
    Progress progress;
    const fs::path file = archive(Format::zip);
    const auto scanned = scanPlace(file, progress);
    ASSERT_TRUE(scanned) << scanned.error().message;
    ASSERT_EQ(scanned->scan.skipped.size(), 1u);
    EXPECT_EQ(scanned->scan.skipped.front().file, file / "c" / files.front().filename());
}

TEST_F(ScannedPlaceTest, AnArchiveWithoutImagesIsAnError) {
    const std::size_t before = copies();
    const fs::path file = folder_ / "letters.zip";
    unpack::test::writeArchive(file, Format::zip,
                               {{.name = "a.txt", .content = "Dear"}, {.name = "b.txt", .content = "Sir"}});
    const auto study = open(file);
    ASSERT_FALSE(study);
    EXPECT_EQ(study.error().code, ErrorCode::inputNotUsable);
    EXPECT_TRUE(
        study.error().message.english().starts_with("The archive was unpacked. There is no DICOM image"))
        << study.error().message;
    EXPECT_EQ(study.error().where, file.string());
    EXPECT_EQ(copies(), before);
}

// Content decides.
TEST_F(ScannedPlaceTest, AnImageThatIsCalledAnArchiveIsAnImage) {
    const auto files = write(smallVolume(), folder_ / "named");
    for (const fs::path& each : files) fs::rename(each, fs::path(each).replace_extension(".zip"));
    const auto study = open(fs::path(files.front()).replace_extension(".zip"));
    ASSERT_TRUE(study) << study.error().message;
    EXPECT_EQ(study->volume->size().z, int(files.size()));
}

TEST_F(ScannedPlaceTest, MessagesAreDocumented) {
    std::ifstream file(macula::test::projectFolder() / "docs/dicom.md");
    const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    for (const char* key : {key::kArchiveCutOff, key::kArchiveEncrypted, key::kArchiveDamaged,
                            key::kArchiveLinks, key::kArchiveOutside})
        EXPECT_NE(page.find("| `" + std::string(key) + "` |"), std::string::npos) << key;
}

// ../shared/data/planar/6_containers: a patient's CD with a DICOMDIR, and a ZIP as a portal gives out.
TEST_F(ScannedPlaceTest, RealArchivesHoldTheirStudies) {
    SKIP_WITHOUT_SHARED_DATA();
    const fs::path data = sharedData() / "planar";
    if (!fs::exists(data / "6_containers")) GTEST_SKIP() << "no archives in the test data";
    std::ifstream truth(data / "truth/6_containers.json");
    const auto archives = nlohmann::json::parse(truth);
    for (const auto& [name, about] : archives.items()) {
        const char* const list = about.contains("files") ? "files" : "members";
        if (!about.contains(list) || !fs::exists(data / name)) continue;
        const auto& files = about[list];
        const auto dicomFiles = std::size_t(std::ranges::count_if(files, [](const auto& file) {
            return file["dicom"].template get<bool>() &&
                   !file["name"].template get<std::string>().ends_with("DICOMDIR");
        }));
        Progress progress;
        const auto scanned = scanPlace(data / name, progress);
        ASSERT_TRUE(scanned) << name << ": " << scanned.error().message;
        EXPECT_EQ(scanned->scan.imageCount() + scanned->scan.objectCount(), dicomFiles) << name;
        EXPECT_EQ(scanned->scan.listedFilesMissing, 0u) << name;
        EXPECT_TRUE(scanned->scan.skipped.empty()) << name;
        EXPECT_EQ(scanned->scan.patients, name.ends_with(".iso") ? 2 : 1);
        EXPECT_TRUE(open(data / name)) << name;
    }
}

}  // namespace
}  // namespace macula::study
