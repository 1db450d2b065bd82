// Series whose identifiers were made anew for each slice: asked about, and joined when a person says so.
#include "dicom/split/join.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "dicom/write/referenced_series.h"
#include "hostile_studies.h"
#include "pitfalls/opened.h"

namespace macula::dicom::test {
namespace {

class Join : public ::testing::Test {
  protected:
    void write(std::string_view name) {
        for (const HostileStudy& study : hostileStudies()) {
            if (study.name == name) study.write(folder.path());
        }
    }
    Scan scanIt(bool join) {
        Progress progress;
        auto scan = scanFolder(folder.path(), progress, {.join = join});
        EXPECT_TRUE(scan);
        return scan ? std::move(*scan) : Scan{};
    }

    TemporaryFolder folder;
    SyntheticSeries series;
};

TEST_F(Join, AsksAndDoesNothingByItself) {
    for (const char* name : {"series-uid-per-slice", "study-uid-per-slice", "patient-id-per-slice"}) {
        SCOPED_TRACE(name);
        std::filesystem::remove_all(folder.path());
        write(name);
        const Scan scan = scanIt(false);
        ASSERT_EQ(scan.messages.size(), 1u);
        EXPECT_EQ(scan.messages[0].key, key::kUidPerSlice);
        const ChosenStack choice = bestVolume(scan);
        EXPECT_FALSE(choice);
        EXPECT_NE(choice.why.english().find("--join"), std::string::npos) << choice.why;
    }
}

TEST_F(Join, MakesOneSeriesWhenAskedTo) {
    for (const char* name : {"series-uid-per-slice", "study-uid-per-slice", "patient-id-per-slice"}) {
        SCOPED_TRACE(name);
        std::filesystem::remove_all(folder.path());
        write(name);
        const Scan scan = scanIt(true);
        ASSERT_EQ(scan.studies.size(), 1u);
        ASSERT_EQ(scan.studies[0].series.size(), 1u);
        const Series& joined = scan.studies[0].series[0];
        EXPECT_TRUE(hasMessage(joined, key::kJoined)) << keysOf(joined);
        EXPECT_TRUE(scan.messages.empty());
        const auto volume = load(joined);
        ASSERT_NE(volume, nullptr);
        expectVolumeOf(*volume, series);
        EXPECT_FALSE(volume->provenance().assumptions.empty());
    }
}

TEST_F(Join, ObjectsForTheArchiveReferToNoJoinedSeries) {
    write("series-uid-per-slice");
    const Result<void> refused = checkReferable(scanIt(true).studies.at(0).series.at(0));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::usage);
    for (const Study& study : scanIt(false).studies)
        for (const Series& one : study.series) EXPECT_TRUE(checkReferable(one));
}

// Three images that continue each other, of two patients: no identifier for each, and none for all.
TEST_F(Join, TwoPatientsAreNeverJoined) {
    auto slices = slicesOf(series);
    for (std::size_t n = 0; n < slices.size(); ++n) {
        slices[n].edits.push_back([n](DcmItem& item) {
            put(item, DCM_SeriesInstanceUID, "2.25.5" + std::to_string(n));
            put(item, DCM_PatientID, n % 2 == 0 ? "A" : "B");
        });
    }
    writeFiles(folder.path(), series, slices);
    const Scan scan = scanIt(true);
    EXPECT_EQ(scan.patients, 2);
    for (const Study& study : scan.studies) {
        for (const Series& one : study.series) EXPECT_EQ(one.instances, 1u);
    }
}

// Slices that do not make a stack are single images, and nobody is asked.
TEST_F(Join, SingleImagesAreNoSeries) {
    series.places = {0, 1.3, 5, 5.4, 17, 40};
    auto slices = slicesOf(series);
    for (std::size_t n = 0; n < slices.size(); ++n) {
        slices[n].edits.push_back(
            [n](DcmItem& item) { put(item, DCM_SeriesInstanceUID, "2.25.5" + std::to_string(n)); });
    }
    writeFiles(folder.path(), series, slices);
    EXPECT_TRUE(scanIt(false).messages.empty());
    EXPECT_EQ(scanIt(true).studies[0].series.size(), 6u);
}

}  // namespace
}  // namespace macula::dicom::test
