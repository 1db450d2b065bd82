// Where no image was taken, in every plane, and in what is measured there.
#include "slices/interpolated.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "made_volumes.h"

namespace macula::slices {
namespace {

using Ranges = std::vector<SliceRange>;

// 20 x 20 x 10 voxels of 1 x 1 x 2 mm, of which slices 3 to 4 and 8 are interpolated. Values are those of k.
Volume withGaps() {
    VolumeOptions options{.size = {20, 20, 10},
                          .worldFromVoxel = affine({1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {0, 0, 0})};
    options.provenance.interpolatedSlices = {{3, 4}, {8, 8}};
    std::vector<std::uint16_t> voxels;
    for (int n = 0; n < 20 * 20 * 10; ++n) voxels.push_back(std::uint16_t(n / 400));
    auto made = Volume::create(std::move(options), std::move(voxels));
    return *std::move(made);
}

SliceFrame frameOf(Orientation orientation, const glm::dvec3& centreMm, glm::ivec2 sizePx = {60, 60}) {
    return {.plane = planeOf(orientation, centreMm), .mmPerPixel = 0.5, .sizePx = sizePx};
}

TEST(Interpolated, SlicesThemselves) {
    const Volume volume = withGaps();
    for (int k = 0; k < 10; ++k) EXPECT_EQ(isInterpolated(volume, k), k == 3 || k == 4 || k == 8) << k;
}

TEST(Interpolated, PlanesAcrossMeetAllAndAxialOnesTheirOwn) {
    const Volume volume = withGaps();
    const Ranges all{{3, 4}, {8, 8}};
    for (const Orientation across : {Orientation::coronal, Orientation::sagittal})
        EXPECT_EQ(interpolatedIn(volume, frameOf(across, {10, 10, 9}), {}), all);
    for (int k = 0; k < 10; ++k) {
        const Ranges met = interpolatedIn(volume, frameOf(Orientation::axial, {10, 10, 2.0 * k}), {});
        EXPECT_EQ(met, k == 3 || k == 4 ? Ranges{all[0]} : k == 8 ? Ranges{all[1]} : Ranges{}) << k;
    }
    // Zoomed in to where none is: 10 pixels are 5 mm, that is slices 4.75 to 7.25.
    EXPECT_EQ(interpolatedIn(volume, frameOf(Orientation::coronal, {10, 10, 12}, {60, 10}), {}), Ranges{});
}

TEST(Interpolated, ASlabReachesWhatItsPlaneDoesNot) {
    const Volume volume = withGaps();
    const SliceFrame frame = frameOf(Orientation::axial, {10, 10, 12.0});  // slice 6
    EXPECT_EQ(interpolatedIn(volume, frame, {.thicknessMm = 2.0}), Ranges{});
    EXPECT_EQ(interpolatedIn(volume, frame, {.thicknessMm = 8.0}), (Ranges{{3, 4}, {8, 8}}));
}

// In a coronal picture the head is up: slice 4 ends, 9 mm from the origin, above where slice 3 begins at 5
// mm.
TEST(Interpolated, EdgesLieBetweenSlicesAndEndWithTheVolume) {
    const Volume volume = withGaps();
    const SliceFrame frame = frameOf(Orientation::coronal, {9.5, 10, 9.0});  // 30 mm, from 24 mm down to -6
    const std::vector<PictureLine> edges = edgesOf({3, 4}, volume, frame);
    ASSERT_EQ(edges.size(), 2u);
    for (std::size_t n = 0; n < 2; ++n) {
        const double yPx = (24.0 - (n == 0 ? 5.0 : 9.0)) / 0.5;
        EXPECT_NEAR(edges[n].from.y, yPx, 1e-9);
        EXPECT_NEAR(edges[n].to.y, yPx, 1e-9);
        // The volume is 20 mm wide, in the middle of the 30.
        EXPECT_NEAR(std::min(edges[n].from.x, edges[n].to.x), 10.0, 1e-9);
        EXPECT_NEAR(std::max(edges[n].from.x, edges[n].to.x), 50.0, 1e-9);
    }
    EXPECT_TRUE(edgesOf({3, 4}, volume, frameOf(Orientation::axial, {10, 10, 6})).empty());
}

// Of any plane, every point of an edge lies half way between two slices.
TEST(Interpolated, EdgesOfObliquePlanesAreBetweenSlices) {
    test::Random random(5);
    for (const test::Pose& pose : test::poses()) {
        SCOPED_TRACE(pose.name);
        const Volume volume = test::storedVolume({12, 11, 10}, pose.worldFromVoxel, test::Padding::none);
        const glm::dmat4 voxelFromWorld = glm::inverse(volume.worldFromVoxel());
        int found = 0;
        for (int n = 0; n < 20; ++n) {
            const SliceFrame frame{.plane = test::randomPlane(test::middleMm(volume), random),
                                   .mmPerPixel = 0.3,
                                   .sizePx = {300, 200}};
            for (const PictureLine& edge : edgesOf({4, 5}, volume, frame)) {
                ++found;
                for (const glm::dvec2& px : {edge.from, edge.to}) {
                    const double k = transformPoint(voxelFromWorld, frame.worldFromPicture(px)).z;
                    EXPECT_NEAR(std::min(std::abs(k - 3.5), std::abs(k - 5.5)), 0.0, 1e-6);
                }
            }
        }
        EXPECT_GT(found, 10);
    }
}

TEST(Interpolated, EllipsesSayHowMuchOfThemIs) {
    const Volume volume = withGaps();
    // Columns of one voxel: slices 2 to 7 of a coronal plane, two of which are interpolated.
    Ellipse across{.plane = planeOf(Orientation::coronal, {10.0, 10.0, 9.0}), .radiiMm = {0.4, 5.9}};
    const auto values = valuesIn(across, volume);
    ASSERT_TRUE(values);
    EXPECT_EQ(values->voxels, 6u);
    EXPECT_EQ(values->interpolated, 2u);
    EXPECT_DOUBLE_EQ(interpolatedShare({.shape = across}, volume), 2.0 / 6.0);
    across.plane = planeOf(Orientation::axial, {10.0, 10.0, 16.0});
    across.radiiMm = {3.0, 3.0};
    EXPECT_DOUBLE_EQ(interpolatedShare({.shape = across}, volume), 1.0);
    across.plane.centreMm.z = 4.0;
    EXPECT_DOUBLE_EQ(interpolatedShare({.shape = across}, volume), 0.0);
    EXPECT_DOUBLE_EQ(interpolatedShare({.shape = Distance{{glm::dvec3(2, 2, 0), {2, 2, 7.0}}}}, volume), 0.5);
}

TEST(Interpolated, TheProbeTells) {
    const Volume volume = withGaps();
    EXPECT_TRUE(probe(volume, {5, 5, 6.0})->isInterpolated);
    EXPECT_FALSE(probe(volume, {5, 5, 4.0})->isInterpolated);
}

TEST(SliceOf, IsThatInWhichAllOfItLies) {
    const Volume volume = withGaps();
    Ellipse ellipse{.plane = planeOf(Orientation::axial, {10.0, 10.0, 8.0}), .radiiMm = {3.0, 3.0}};
    EXPECT_EQ(sliceOf({.shape = ellipse}, volume), 4);
    ellipse.plane = planeOf(Orientation::coronal, {10.0, 10.0, 8.0});
    EXPECT_EQ(sliceOf({.shape = ellipse}, volume), std::nullopt) << "through several";
    EXPECT_EQ(sliceOf({.shape = Distance{{glm::dvec3(0, 0, 6.3), {9, 9, 5.6}}}}, volume), 3);
    EXPECT_EQ(sliceOf({.shape = Distance{{glm::dvec3(0, 0, 6), {9, 9, 8}}}}, volume), std::nullopt);
    EXPECT_EQ(sliceOf({.shape = Distance{{glm::dvec3(0, 0, 40), {9, 9, 40}}}}, volume), std::nullopt);
}

}  // namespace
}  // namespace macula::slices
