// Structure sets: contours made here with areas in closed form, and those of ../shared/data against counts of
// voxels that were made without this code.
#include "dicom/segmentation/structure_set.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "support.h"
#include "synthetic.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct DrawnContour {
    Contour points;
    const char* type = "CLOSED_PLANAR";
};
struct DrawnRegion {
    std::string name;
    std::vector<DrawnContour> contours;
};

void writeStructures(const fs::path& file, const std::vector<DrawnRegion>& regions) {
    Shell shell{.sopClassUid = UID_RTStructureSetStorage, .modality = "RTSTRUCT"};
    shell.edits.push_back([&](DcmItem& item) {
        put(item, DCM_StructureSetLabel, "DRAWN");
        for (std::size_t r = 0; r < regions.size(); ++r) {
            const auto at = static_cast<long>(r);
            DcmItem* region = nullptr;
            item.findOrCreateSequenceItem(DCM_StructureSetROISequence, region, at);
            put(*region, DCM_ROINumber, std::to_string(r + 1));
            put(*region, DCM_ReferencedFrameOfReferenceUID, "2.25.1002");
            put(*region, DCM_ROIName, regions[r].name);
            DcmItem* drawn = nullptr;
            item.findOrCreateSequenceItem(DCM_ROIContourSequence, drawn, at);
            put(*drawn, DCM_ReferencedROINumber, std::to_string(r + 1));
            put(*drawn, DCM_ROIDisplayColor, "255\\128\\0");
            for (std::size_t c = 0; c < regions[r].contours.size(); ++c) {
                const DrawnContour& contour = regions[r].contours[c];
                DcmItem* one = nullptr;
                drawn->findOrCreateSequenceItem(DCM_ContourSequence, one, static_cast<long>(c));
                std::string data;
                for (const glm::dvec3& p : contour.points)
                    data += fmt::format("{}{:.9g}\\{:.9g}\\{:.9g}", data.empty() ? "" : "\\", p.x, p.y, p.z);
                put(*one, DCM_ContourGeometricType, contour.type);
                put(*one, DCM_NumberOfContourPoints, std::to_string(contour.points.size()));
                put(*one, DCM_ContourData, data);
            }
        }
    });
    writeShell(file, shell);
}

DrawnContour circle(const glm::dvec3& centre, double radius, bool isClockwise = false) {
    constexpr int kPoints = 720;
    DrawnContour contour;
    for (int i = 0; i < kPoints; ++i) {
        const double angle = (isClockwise ? -1 : 1) * 2.0 * std::numbers::pi * i / kPoints;
        contour.points.push_back(centre + radius * glm::dvec3(std::cos(angle), std::sin(angle), 0.0));
    }
    return contour;
}

// Voxels of 1 x 1 x 3 mm.
constexpr glm::ivec3 kSize(60, 50, 12);
const glm::dmat4 kWorldFromVoxel = affine({1, 0, 0}, {0, 1, 0}, {0, 0, 3}, {-30, -25, 100});

class StructureSetTest : public testing::Test {
  protected:
    RegionVoxels voxels(const std::vector<DrawnRegion>& regions) {
        writeStructures(folder_ / "structures.dcm", regions);
        const auto read = readStructureSet(folder_ / "structures.dcm");
        EXPECT_TRUE(read);
        if (!read) return {};
        read_ = *read;
        Progress progress;
        auto made = voxelsOf(*read, kWorldFromVoxel, kSize, progress);
        EXPECT_TRUE(made);
        return made ? *std::move(made) : RegionVoxels{};
    }
    SegmentVoxels only(const std::vector<DrawnContour>& contours) {
        auto made = voxels({{"Region", contours}});
        EXPECT_EQ(made.sets.segments.size(), 1u);
        return made.sets.segments.empty() ? SegmentVoxels{} : std::move(made.sets.segments[0]);
    }
    TemporaryFolder folder_;
    StructureSet read_;
};

TEST_F(StructureSetTest, NamesColoursAndNumbersAreRead) {
    voxels({{"Bladder", {circle({0, 0, 103}, 5)}}, {"Prostate", {}}});
    EXPECT_EQ(read_.label, "DRAWN");
    ASSERT_EQ(read_.regions.size(), 2u);
    EXPECT_EQ(read_.regions[0].segment.label, "Bladder");
    EXPECT_EQ(read_.regions[0].frameOfReferenceUid, "2.25.1002");
    EXPECT_EQ(read_.regions[0].segment.number, 1);
    EXPECT_EQ(read_.regions[0].segment.recommendedRgb, (std::array<std::uint8_t, 3>{255, 128, 0}));
    EXPECT_TRUE(read_.regions[1].contours.empty());
}

TEST_F(StructureSetTest, AVolumeIsThatOfItsContours) {
    std::vector<DrawnContour> contours;
    for (int k = 2; k < 8; ++k) contours.push_back(circle({1.3, 2.4, 100.0 + 3 * k}, 10, k % 2 == 0));
    const SegmentVoxels made = only(contours);
    ASSERT_TRUE(made.volumeMm3 && made.centroidMm);
    const double expected = std::numbers::pi * 100 * 18;
    EXPECT_NEAR(*made.volumeMm3, expected, 1e-3 * expected);
    EXPECT_NEAR(glm::length(*made.centroidMm - glm::dvec3(1.3, 2.4, 113.5)), 0.0, 1e-6);
    EXPECT_NEAR(3.0 * double(made.voxels.count()), expected, 0.01 * expected);
    EXPECT_FALSE(made.voxels.contains({31, 27, 1}));
    EXPECT_TRUE(made.voxels.contains({31, 27, 2}));
    EXPECT_TRUE(made.voxels.contains({31, 27, 7}));
    EXPECT_FALSE(made.voxels.contains({31, 27, 8}));
}

TEST_F(StructureSetTest, ANestedContourAndAKeyholeAreTheSameHole) {
    const glm::dvec3 at(0, 0, 109);
    DrawnContour keyhole = circle(at, 12);
    keyhole.points.push_back(keyhole.points.front());
    const DrawnContour hole = circle(at, 5, true);
    keyhole.points.insert(keyhole.points.end(), hole.points.begin(), hole.points.end());
    keyhole.points.push_back(hole.points.front());
    const SegmentVoxels nested = only({circle(at, 12), circle(at, 5)});
    const SegmentVoxels keyed = only({keyhole});
    const double expected = std::numbers::pi * (144 - 25) * 3;
    EXPECT_NEAR(nested.volumeMm3.value_or(0), expected, 1e-3 * expected);
    EXPECT_NEAR(keyed.volumeMm3.value_or(0), expected, 1e-3 * expected);
    EXPECT_EQ(nested.voxels, keyed.voxels);
    EXPECT_FALSE(nested.voxels.contains({30, 25, 3})) << "the middle of the hole";
    EXPECT_TRUE(nested.voxels.contains({38, 25, 3}));
    // An island in the hole, and what lies beside it.
    const SegmentVoxels island =
        only({circle(at, 12), circle(at, 5), circle(at, 2), circle({-22, 0, 109}, 3)});
    EXPECT_TRUE(island.voxels.contains({30, 25, 3}));
    EXPECT_FALSE(island.voxels.contains({33, 25, 3}));
    EXPECT_TRUE(island.voxels.contains({8, 25, 3}));
}

TEST_F(StructureSetTest, ContoursBetweenSlicesBelongToBothAndSparseOnesToThoseNear) {
    const SegmentVoxels between = only({circle({0, 0, 104.5}, 6)});
    EXPECT_TRUE(between.voxels.contains({30, 25, 1}));
    EXPECT_TRUE(between.voxels.contains({30, 25, 2}));
    EXPECT_FALSE(between.voxels.contains({30, 25, 3}));
    const auto sparse = voxels({{"Region", {circle({0, 0, 103}, 6), circle({0, 0, 112}, 6)}}});
    EXPECT_TRUE(sparse.isBetween);
    for (int k = 0; k <= 5; ++k) EXPECT_TRUE(sparse.sets.segments[0].voxels.contains({30, 25, k})) << k;
    EXPECT_FALSE(sparse.sets.segments[0].voxels.contains({30, 25, 6}));
    const double expected = std::numbers::pi * 36 * 18;
    EXPECT_NEAR(sparse.sets.segments[0].volumeMm3.value_or(0), expected, 1e-3 * expected);
}

TEST_F(StructureSetTest, WhatEnclosesNothingIsCountedAndLeftOut) {
    DrawnContour tilted = circle({0, 0, 109}, 8);
    for (glm::dvec3& point : tilted.points) point.z += 0.1 * point.x;
    const auto made = voxels({{"Region",
                               {{{{0, 0, 103}}, "POINT"},
                                {{{0, 0, 103}, {5, 0, 103}}, "OPEN_PLANAR"},
                                {{{0, 0, 103}, {5, 0, 103}}, "CLOSED_PLANAR"},
                                {{{0, 0, 103}, {5, 0, 103}, {1e30, 0, 103}}, "CLOSED_PLANAR"},
                                tilted,
                                circle({0, 0, 103}, 4)}}});
    EXPECT_EQ(read_.regions[0].points, 2u);
    EXPECT_EQ(read_.regions[0].unusable, 2u);
    EXPECT_EQ(made.oblique, 1u);
    const double expected = std::numbers::pi * 16 * 3;
    EXPECT_NEAR(made.sets.segments[0].volumeMm3.value_or(0), expected, 1e-3 * expected);
}

TEST_F(StructureSetTest, UnevenPlanesAreSaid) {
    const auto made = voxels(
        {{"Region",
          {circle({0, 0, 103}, 4), circle({0, 0, 106}, 4), circle({0, 0, 109}, 4), circle({0, 0, 118}, 4)}}});
    EXPECT_TRUE(made.isUneven);
    EXPECT_FALSE(made.sets.segments[0].voxels.contains({30, 25, 4})) << "nothing is filled in between";
    EXPECT_FALSE(voxels({{"Region", {circle({0, 0, 103}, 4), circle({0, 0, 106}, 4)}}}).isUneven);
}

TEST_F(StructureSetTest, OutsideOfTheGridNothingIsFilledButTheVolumeStays) {
    const SegmentVoxels outside = only({circle({500, 0, 103}, 6)});
    EXPECT_TRUE(outside.voxels.isEmpty());
    EXPECT_NEAR(outside.volumeMm3.value_or(0), std::numbers::pi * 36 * 3, 1.0);
    const SegmentVoxels above = only({circle({0, 0, 5000}, 6)});
    EXPECT_TRUE(above.voxels.isEmpty());
    // Larger than the grid: all of the slice.
    EXPECT_EQ(only({circle({0, 0, 103}, 400)}).voxels.count(), std::size_t(60 * 50));
}

TEST_F(StructureSetTest, WhatIsNoneIsAnError) {
    std::ofstream(folder_ / "text.dcm") << "no structure set";
    EXPECT_FALSE(readStructureSet(folder_ / "text.dcm"));
    EXPECT_FALSE(readStructureSet(folder_ / "gone.dcm"));
    const SyntheticSeries series;
    const auto files = writeFiles(folder_.path(), series);
    const auto image = readStructureSet(files[0]);
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().code, ErrorCode::inputNotUsable);
}

struct RealSet {
    const char* images;
    const char* structures;
};

TEST_F(StructureSetTest, OfRealSetsAreTheTruth) {
    SKIP_WITHOUT_SHARED_DATA();
    const fs::path data = sharedData() / "planar";
    if (!fs::is_directory(data)) GTEST_SKIP() << "the planar data are not on this machine";
    std::ifstream stream(data / "truth" / "3_radiotherapy.json");
    const Json truth = Json::parse(stream);
    for (const RealSet& real :
         {RealSet{"3_radiotherapy/made_rt_full_hfs/ct", "3_radiotherapy/made_rt_full_hfs/rtstruct.dcm"},
          RealSet{"3_radiotherapy/rt_sarcoma_sts008/ct", "3_radiotherapy/rt_sarcoma_sts008/rtstruct.dcm"}}) {
        SCOPED_TRACE(real.structures);
        const auto found = scan(data / real.images);
        ASSERT_TRUE(found);
        const Stack& stack = found->studies.at(0).series.at(0).stacks.at(0);
        ASSERT_TRUE(stack.worldFromVoxel);
        const auto structures = readStructureSet(data / real.structures);
        ASSERT_TRUE(structures);
        Progress progress;
        const auto positions = slicePositionsMm(stack);
        const auto made =
            voxelsOf(*structures, *stack.worldFromVoxel,
                     {stack.columns, stack.rows, int(stack.slices.size())}, progress, positions);
        ASSERT_TRUE(made);
        const Json& regions = truth[real.structures]["rtstruct"]["rois"];
        ASSERT_EQ(made->sets.segments.size(), regions.size());
        for (std::size_t r = 0; r < regions.size(); ++r) {
            const Json& region = regions[r];
            SCOPED_TRACE(region["name"]);
            const SegmentVoxels& segment = made->sets.segments[r];
            EXPECT_EQ(segment.segment.label, region["name"].get<std::string>());
            if (!region.contains("volume_ml_planimetry")) continue;
            const double ml = region["volume_ml_planimetry"].get<double>();
            EXPECT_NEAR(segment.volumeMm3.value_or(0.0) / 1000.0, ml, 0.01 * ml);
            // Macula fills slices between planes that lie farther apart than slices.
            const double apart = region["plane_spacing_mm"].get<double>() / (*stack.spacingMm).z;
            const double voxels = region["voxels_pixel_centre_inside"].get<double>() * std::round(apart);
            EXPECT_NEAR(double(segment.voxels.count()), voxels, 0.01 * voxels);
        }
    }
}

}  // namespace
}  // namespace macula::dicom::test
