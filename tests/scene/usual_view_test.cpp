#include "scene/camera/usual_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "base/phantom.h"
#include "base/quantised.h"
#include "pictures/fitted_view.h"
#include "scene/camera/orbit_camera.h"
#include "scene/camera/view_directions.h"

namespace macula::scene {
namespace {

// Of HU: a body with half axes `halfMm` amid air, the long axis of the grid along z. `sizeMm` is the box.
struct Scan {
    glm::dvec3 sizeMm{250.0};
    glm::dvec3 halfMm{75.0, 95.0, 110.0};
    std::string bodyPart = {};
    Unit unit = Unit::hounsfield;
    bool isSagittal = false;  // stored as sagittal slices
};

Volume scanOf(const Scan& scan) {
    constexpr double kVoxelMm = 4.0;
    const glm::ivec3 along = glm::max(glm::ivec3(glm::round(scan.sizeMm / kVoxelMm)), glm::ivec3(1));
    // Columns, rows and slices: along x, y, z; or of sagittal ones along y, down z, and x.
    const glm::ivec3 size = scan.isSagittal ? glm::ivec3(along.y, along.z, along.x) : along;
    const glm::dvec3 first = 0.5 * kVoxelMm * (glm::dvec3(1.0) - glm::dvec3(along));
    const glm::dmat4 place =
        scan.isSagittal
            ? affine({0, kVoxelMm, 0}, {0, 0, -kVoxelMm}, {kVoxelMm, 0, 0}, {first.x, first.y, -first.z})
            : affine({kVoxelMm, 0, 0}, {0, kVoxelMm, 0}, {0, 0, kVoxelMm}, first);
    std::vector<std::uint16_t> voxels;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                const glm::dvec3 at = transformPoint(place, glm::dvec3(i, j, k)) / scan.halfMm;
                voxels.push_back(glm::dot(at, at) <= 1.0 ? 1064 : 24);  // 40 and -1000 HU
            }
    return Volume::create({.size = size,
                           .worldFromVoxel = place,
                           .unitsFromStored = {1.0, -1024.0},
                           .unit = scan.unit,
                           .modality = "CT",
                           .bodyPart = scan.bodyPart},
                          std::move(voxels))
        .value();
}

UsualView of(const Scan& scan) {
    return usualView(scanOf(scan));
}

TEST(UsualView, OfAHeadIsAThreeQuarterView) {
    const UsualView byShape{ViewDirection::threeQuarter, ViewReason::headByShape};
    const UsualView byCode{ViewDirection::threeQuarter, ViewReason::headByCode};
    EXPECT_EQ(of({}), byShape);
    EXPECT_EQ(of({.isSagittal = true}), byShape) << "however slices are stored";
    EXPECT_EQ(of({.unit = Unit::raw}), byShape) << "as of MR";
    EXPECT_EQ(of({.sizeMm = {400, 400, 140}, .halfMm = {75, 95, 300}}), byShape)
        << "a short scan of a head in a large field";
    for (const char* code : {"HEAD", "head ", "BRAIN", "SKULL"})
        EXPECT_EQ(of({.bodyPart = code}), byCode) << code;
    EXPECT_EQ(of({.sizeMm = {250, 250, 64}, .bodyPart = "HEAD"}), byCode);
}

TEST(UsualView, OfWhatTheImagesSayIsNoHeadGoesByThat) {
    for (const char* code : {"KNEE", "CHEST", "HEART", "X"})
        EXPECT_EQ(of({.bodyPart = code}), (UsualView{ViewDirection::turned, ViewReason::body})) << code;
}

TEST(UsualView, OfAShortScanIsOblique) {
    const UsualView isShort{ViewDirection::oblique, ViewReason::shortScan};
    EXPECT_EQ(of({.sizeMm = {340, 340, 76}, .halfMm = {160, 110, 400}}), isShort);
    EXPECT_EQ(of({.sizeMm = {250, 250, 40}, .bodyPart = "HEAD"}), isShort) << "a band of a head";
    EXPECT_EQ(of({.sizeMm = {250, 250, 4}}), isShort) << "one slice";
}

TEST(UsualView, OfABodyIsSlightlyTurned) {
    const UsualView body{ViewDirection::turned, ViewReason::body};
    EXPECT_EQ(of({.sizeMm = {400, 400, 300}, .halfMm = {180, 110, 400}}), body) << "a chest";
    EXPECT_EQ(of({.sizeMm = {200, 200, 150}, .halfMm = {300, 300, 300}}), body)
        << "a heart, cut out of a body by a small field";
    EXPECT_EQ(of({.sizeMm = {160, 160, 150}, .halfMm = {50, 60, 200}}), body) << "a knee";
    EXPECT_EQ(of({.unit = Unit::suvBodyWeight}), body) << "uptake has no shape";
    EXPECT_EQ(of({.halfMm = glm::dvec3(1e-3)}), body) << "nothing but air";
    EXPECT_EQ(usualView(phantom::make({.size = {64, 56, 40}, .spacingMm = {4.8, 4.8, 7.5}})), body);
}

TEST(UsualView, HoldsAtTheExtremes) {
    std::vector<float> voxels(8, std::numeric_limits<float>::quiet_NaN());
    const auto nothing = Volume::createFloat({.size = {2, 2, 2}, .unit = Unit::raw}, std::move(voxels));
    ASSERT_TRUE(nothing.ok());
    EXPECT_FALSE(matterExtent(*nothing));
    EXPECT_EQ(usualView(*nothing).from, ViewDirection::turned);
    const auto one = Volume::create({.size = {1, 1, 1}, .unit = Unit::hounsfield}, {1});
    ASSERT_TRUE(one.ok());
    EXPECT_EQ(matterExtent(*one)->sizeMm, glm::dvec3(0.0));
    EXPECT_EQ(usualView(*one).from, ViewDirection::turned);
}

TEST(UsualView, MeasuresWhatLiesInTheVolume) {
    const auto head = matterExtent(scanOf({}));
    ASSERT_TRUE(head);
    EXPECT_EQ(head->cutAside, 0.0);
    // Of an ellipsoid 1 % of the volume lies beyond 0.88 of a half axis: (1 - t)^2 (2 + t) / 4 = 0.01.
    EXPECT_NEAR(head->sizeMm.x, 2 * 75 * 0.88, 8.0);
    EXPECT_NEAR(head->sizeMm.z, 2 * 110 * 0.88, 8.0);
    EXPECT_GT(matterExtent(scanOf({.sizeMm = {200, 200, 150}, .halfMm = glm::dvec3(300)}))->cutAside, 0.9);
}

// Quantised for drawing, and from DICOM or not, it is the same patient.
TEST(UsualView, IsThatOfTheVolumeInSixteenBits) {
    std::vector<float> voxels(64, 0.25f);
    voxels.front() = 1e6f;
    auto volume = Volume::createFloat({.size = {4, 4, 4}, .bodyPart = "HEAD"}, std::move(voxels));
    ASSERT_TRUE(volume.ok());
    const auto whole = std::make_shared<const Volume>(*std::move(volume));
    EXPECT_EQ(in16Bits(whole)->bodyPart(), "HEAD");
}

TEST(UsualView, IsNeverMirrored) {
    for (const ViewDirection from :
         {ViewDirection::oblique, ViewDirection::threeQuarter, ViewDirection::turned}) {
        const CameraBasis axes = standardBasis(from);
        EXPECT_GT(axes.right.x, 0.5) << "the patient's left is on the right of the picture";
        EXPECT_GT(axes.up.z, 0.5);
        EXPECT_GT(axes.forward.y, 0.5) << "seen from the front";
        EXPECT_LT(axes.forward.z, 0.0) << "and from above";
        EXPECT_NEAR(glm::determinant(glm::dmat3(axes.right, axes.up, -axes.forward)), 1.0, 1e-12);
        const Camera orbit = toCamera(turnedTo({}, from));
        const CameraBasis same = basis(orbit).value();
        EXPECT_LT(glm::distance(same.forward, axes.forward), 1e-12) << nameOf(from);
        EXPECT_LT(glm::distance(same.up, axes.up), 1e-12) << nameOf(from);
        EXPECT_EQ(viewDirectionOf(nameOf(from)), from);
    }
}

TEST(UsualView, IsOfWhoeverFitsACamera) {
    const Volume head = scanOf({});
    EXPECT_EQ(firstDirection(std::nullopt, head), ViewDirection::threeQuarter);
    EXPECT_EQ(firstDirection(ViewDirection::left, head), ViewDirection::left) << "who asks is given that";
    const Camera camera = pictures::fittedCamera({}, trace::Look::cinematic, head, {});
    const CameraBasis axes = basis(camera).value();
    EXPECT_LT(glm::distance(axes.forward, standardBasis(ViewDirection::threeQuarter).forward), 1e-9);
    for (const ViewReason why :
         {ViewReason::headByCode, ViewReason::headByShape, ViewReason::shortScan, ViewReason::body}) {
        EXPECT_FALSE(nameOf(why).empty());
        EXPECT_TRUE(sentenceOf({.why = why}).english().ends_with('.'));
    }
}

}  // namespace
}  // namespace macula::scene
