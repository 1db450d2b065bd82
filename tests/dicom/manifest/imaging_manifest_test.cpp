// Manifests: what they name, and what a hostile one cannot do.
#include "dicom/manifest/imaging_manifest.h"

#include <gtest/gtest.h>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fstream>

#include "base/printable.h"
#include "support.h"
#include "synthetic_manifest.h"

namespace macula::dicom {
namespace {

namespace fs = std::filesystem;
using test::SyntheticManifest;

class ImagingManifestTest : public ::testing::Test {
  protected:
    Result<ImagingManifest> read(const SyntheticManifest& manifest) {
        test::writeManifest(file_, manifest);
        return readImagingManifest(file_);
    }
    static SyntheticManifest::Series some(std::string study, std::string series,
                                          std::vector<std::string> instances) {
        return {.studyUid = std::move(study),
                .seriesUid = std::move(series),
                .instanceUids = std::move(instances)};
    }

    test::TemporaryFolder folder_;
    fs::path file_ = folder_ / "manifest.dcm";
    test::SyntheticSeries series_;
};

TEST_F(ImagingManifestTest, NamesPatientStudySeriesInstancesAndPlace) {
    SyntheticManifest manifest = test::manifestOf(series_);
    manifest.series[0].url = "https://pacs.example.org/dicom-web/studies/2.25.1000";
    manifest.series[0].wadoUrl = "https://pacs.example.org/dicom-web";
    manifest.series[0].aeTitle = "ARCHIVE";
    manifest.series[0].location = "1.3.6.1.4";
    const auto found = read(manifest);
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(found->patientName, "SYNTHETIC^ONE");
    EXPECT_EQ(found->patient.id, "SYN1");
    ASSERT_EQ(found->studies.size(), 1u);
    EXPECT_EQ(found->studies[0].studyInstanceUid, series_.studyUid);
    ASSERT_EQ(found->studies[0].series.size(), 1u);
    const ManifestSeries& series = found->studies[0].series[0];
    EXPECT_EQ(series.seriesInstanceUid, series_.seriesUid);
    EXPECT_EQ(series.place.urls,
              (std::vector<std::string>{manifest.series[0].url, manifest.series[0].wadoUrl}));
    EXPECT_EQ(series.place.aeTitles, std::vector<std::string>{"ARCHIVE"});
    EXPECT_EQ(series.place.locationUids, std::vector<std::string>{"1.3.6.1.4"});
    ASSERT_EQ(series.instances.size(), manifest.series[0].instanceUids.size());
    for (std::size_t i = 0; i < series.instances.size(); ++i)
        EXPECT_EQ(series.instances[i].sopInstanceUid, manifest.series[0].instanceUids[i]);
    EXPECT_EQ(found->unusable, 0u);
}

TEST_F(ImagingManifestTest, AreKnownByTheCodeOfTheirTitle) {
    SyntheticManifest manifest = test::manifestOf(series_);
    for (const auto& [code, scheme, isOne] :
         std::initializer_list<std::tuple<const char*, const char*, bool>>{
             {"113030", "DCM", true},
             {"131560", "DCM", true},
             {"MADOTEMP001", "99IHE", true},
             {"113000", "DCM", false},  // Of Interest: key images
             {"113030", "99OWN", false}}) {
        manifest.code = code;
        manifest.scheme = scheme;
        EXPECT_EQ(read(manifest).ok(), isOne) << code << scheme;
    }
    manifest = test::manifestOf(series_);
    manifest.edits = {
        [](DcmItem& item) { test::put(item, DCM_SOPClassUID, "1.2.840.10008.5.1.4.1.1.88.11"); }};
    EXPECT_FALSE(read(manifest)) << "a report";
}

TEST_F(ImagingManifestTest, StudiesAndSeriesThatAreNamedTwiceAreOne) {
    SyntheticManifest manifest;
    manifest.series = {some("1.2", "1.2.1", {"1.2.1.1", "1.2.1.2"}),
                       some("1.2", "1.2.1", {"1.2.1.2", "1.2.1.3"}), some("1.3", "1.3.1", {"1.3.1.1"}),
                       some("1.2", "1.2.2", {"1.2.2.1"})};
    const auto found = read(manifest);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->studies.size(), 2u);
    ASSERT_EQ(found->studies[0].series.size(), 2u);
    EXPECT_EQ(found->studies[0].series[0].instances.size(), 3u);
    EXPECT_EQ(found->studies[0].instances(), 4u);
    EXPECT_EQ(found->studies[1].instances(), 1u);
}

TEST_F(ImagingManifestTest, WhatIsNoUidIsLeftOutAndCounted) {
    SyntheticManifest manifest;
    manifest.series = {some("../../etc", "1.2.1", {"1.2.1.1"}), some("1.2", "x", {"1.2.1.1"}),
                       some("1.2", "1.2.1", {"DOE^JOHN", "1.2.1.1"})};
    const auto found = read(manifest);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->unusable, 3u);
    ASSERT_EQ(found->studies.size(), 1u);
    EXPECT_EQ(found->studies[0].instances(), 1u);
}

TEST_F(ImagingManifestTest, AddressesThatNoTerminalShouldSeeAreLeftOut) {
    SyntheticManifest manifest = test::manifestOf(series_);
    for (const char* url : {"https://a/\x01", "https://a/\x1b[2J", "https://a/\x7f"}) {
        manifest.series[0].url = url;
        const auto found = read(manifest);
        ASSERT_TRUE(found);
        for (const std::string& each : found->studies[0].series[0].place.urls)
            EXPECT_EQ(each, printable(each));
    }
    manifest.series[0].url = "https://a/" + std::string(3000, 'a');
    EXPECT_TRUE(read(manifest)->studies[0].series[0].place.urls.empty());
}

TEST_F(ImagingManifestTest, OnesThatNameNothingOrTooMuchAreRefused) {
    SyntheticManifest manifest;
    auto found = read(manifest);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::inputNotUsable);
    EXPECT_FALSE(found.error().hint.empty());
    for (int i = 0; i < 200; ++i)
        manifest.series.push_back(some("1.2." + std::to_string(i), "1.3", {"1.4." + std::to_string(i)}));
    found = read(manifest);
    ASSERT_FALSE(found);
    EXPECT_NE(found.error().message.english().find("more than 100 studies"), std::string::npos);
}

TEST_F(ImagingManifestTest, DeepNestingAndBrokenFilesAreRefused) {
    SyntheticManifest manifest = test::manifestOf(series_);
    manifest.edits = {[](DcmItem& item) {
        DcmItem* inner = &item;
        for (int i = 0; i < 200; ++i) inner = &test::nested(*inner, DCM_ContentSequence);
        test::put(*inner, DCM_ValueType, "TEXT");
    }};
    EXPECT_FALSE(read(manifest));
    ASSERT_TRUE(read(test::manifestOf(series_)));
    const auto whole = fs::file_size(file_);
    for (const std::uintmax_t bytes : {whole - 1, whole / 2, std::uintmax_t(200), std::uintmax_t(0)}) {
        fs::resize_file(file_, bytes);
        const auto cut = readImagingManifest(file_);
        EXPECT_TRUE(!cut || bytes > whole / 2) << bytes;
        EXPECT_TRUE(cut || !cut.error().hint.empty()) << bytes;
    }
    EXPECT_FALSE(readImagingManifest(folder_ / "none.dcm"));
    EXPECT_FALSE(readImagingManifest(folder_.path()));
}

TEST_F(ImagingManifestTest, AFolderSaysWhatItIs) {
    test::writeManifest(file_, test::manifestOf(series_));
    const auto found = test::scan(folder_.path());
    ASSERT_TRUE(found);
    ASSERT_EQ(found->studies.size(), 1u);
    ASSERT_EQ(found->studies[0].series[0].objects.size(), 1u);
    EXPECT_EQ(found->studies[0].series[0].objects[0].kind.english(), "Imaging manifest");
}

}  // namespace
}  // namespace macula::dicom
