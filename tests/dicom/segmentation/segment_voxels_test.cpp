// Segments as sets of voxels: exactly where they were drawn, whatever overlaps; on another grid the nearest.
#include "dicom/segmentation/segment_voxels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/available_memory.h"
#include "base/phantom.h"
#include "support.h"
#include "synthetic_segmentation.h"

namespace macula::dicom::test {
namespace {

// A ball around the middle of the grid.
std::function<double(const glm::dvec3&)> ball(const glm::dvec3& centreMm, double radiusMm) {
    return [=](const glm::dvec3& mm) { return glm::distance(mm, centreMm) <= radiusMm ? 1.0 : 0.0; };
}

class SegmentVoxelsTest : public testing::Test {
  protected:
    Result<SegmentVoxelSets> load(const SyntheticSegmentation& s, const glm::dmat4& worldFromVoxel,
                                  const glm::ivec3& size) {
        writeSegmentation(folder_ / "seg", s);
        const auto header = readSegmentation(folder_ / "seg");
        if (!header) return header.error();
        Progress progress;
        return loadSegmentVoxels(*header, worldFromVoxel, size, progress);
    }
    static glm::dvec3 middle(const SyntheticSegmentation& s) {
        return transformPoint(s.worldFromVoxel, 0.5 * glm::dvec3(s.size - 1));
    }

    TemporaryFolder folder_;
};

SyntheticSegmentation sheared() {
    SyntheticSegmentation s;
    s.size = {21, 19, 17};
    const glm::dmat4 oblique = obliqueAffine();
    s.worldFromVoxel = oblique;
    s.worldFromVoxel[2] += 0.4 * oblique[1];  // a gantry that is tilted
    return s;
}

TEST_F(SegmentVoxelsTest, OverlappingOnesAreWhole) {
    SyntheticSegmentation s = sheared();
    const glm::dvec3 at = middle(s);
    s.parts = {{.number = 1, .label = "Liver", .share = ball(at, 7.0)},
               {.number = 7, .label = "Tumour", .share = ball(at + glm::dvec3(2, 1, 0), 4.0)}};
    const auto sets = load(s, s.worldFromVoxel, s.size);
    ASSERT_TRUE(sets) << sets.error().message;
    EXPECT_FALSE(sets->isResampled);
    EXPECT_EQ(sets->outside, 0u);
    ASSERT_EQ(sets->segments.size(), 2u);
    EXPECT_EQ(sets->segments[1].segment.number, 7);
    EXPECT_EQ(sets->segments[1].segment.label, "Tumour");
    const double voxelMm3 = std::abs(glm::determinant(glm::dmat3(s.worldFromVoxel)));
    std::size_t both = 0;
    for (std::size_t n = 0; n < 2; ++n) {
        const SegmentVoxels& segment = sets->segments[n];
        std::size_t count = 0;
        glm::dvec3 sum(0.0);
        for (int k = 0; k < s.size.z; ++k)
            for (int j = 0; j < s.size.y; ++j)
                for (int i = 0; i < s.size.x; ++i) {
                    const glm::dvec3 mm = transformPoint(s.worldFromVoxel, {i, j, k});
                    const bool isIn = s.parts[n].share(mm) > 0.5;
                    ASSERT_EQ(segment.voxels.contains({i, j, k}), isIn) << n << ": " << i << j << k;
                    if (isIn) {
                        ++count;
                        sum += mm;
                    }
                    if (n == 1 && isIn && s.parts[0].share(mm) > 0.5) ++both;
                }
        ASSERT_TRUE(segment.volumeMm3 && segment.centroidMm);
        EXPECT_NEAR(*segment.volumeMm3, double(count) * voxelMm3, 1e-9 * double(count));
        EXPECT_LT(glm::distance(*segment.centroidMm, sum / double(count)), 1e-9);
    }
    EXPECT_GT(both, 10u) << "they overlap";
}

TEST_F(SegmentVoxelsTest, OnPartOfTheGridWhatLiesOutsideIsTold) {
    SyntheticSegmentation s = sheared();
    s.parts = {{.number = 1, .label = "Liver", .share = ball(middle(s), 9.0)}};
    const auto whole = load(s, s.worldFromVoxel, s.size);
    const glm::ivec3 half(s.size.x / 2, s.size.y, s.size.z);
    const auto part = load(s, s.worldFromVoxel, half);
    ASSERT_TRUE(whole && part);
    EXPECT_GT(part->outside, 0u);
    EXPECT_EQ(part->outside + part->segments[0].voxels.count(), whole->segments[0].voxels.count());
}

TEST_F(SegmentVoxelsTest, OnAnotherGridTheNearestVoxelCountsAndVolumeIsThatOfItsOwn) {
    SyntheticSegmentation s = sheared();
    s.parts = {{.number = 3, .label = "Liver", .share = ball(middle(s), 6.0)}};
    const auto own = load(s, s.worldFromVoxel, s.size);
    ASSERT_TRUE(own);
    const glm::ivec3 size(40, 44, 52);
    const glm::dmat4 other =
        affine({0.5, 0.1, 0}, {0, 0.45, 0.05}, {0, 0, 0.7}, middle(s) - glm::dvec3(10.0, 10.0, 18.0));
    const auto sets = load(s, other, size);
    ASSERT_TRUE(sets) << sets.error().message;
    EXPECT_TRUE(sets->isResampled);
    ASSERT_TRUE(sets->segments[0].volumeMm3);
    EXPECT_NEAR(*sets->segments[0].volumeMm3 / *own->segments[0].volumeMm3, 1.0, 1e-9);
    const glm::dmat4 ownFromOther = glm::inverse(s.worldFromVoxel) * other;
    std::size_t count = 0;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                const glm::dvec3 at = transformPoint(ownFromOther, {i, j, k});
                const glm::dvec3 off = glm::abs(at + 0.5 - glm::round(at + 0.5));
                if (std::min({off.x, off.y, off.z}) < 1e-6) continue;  // on the border of two
                const bool isIn = own->segments[0].voxels.contains(glm::ivec3(glm::round(at)));
                ASSERT_EQ(sets->segments[0].voxels.contains({i, j, k}), isIn) << i << ' ' << j << ' ' << k;
                count += isIn ? 1 : 0;
            }
    EXPECT_GT(count, 1000u);
}

TEST_F(SegmentVoxelsTest, FarFromTheVolumeNothingIsLeft) {
    SyntheticSegmentation s = sheared();
    s.parts = {{.number = 1, .label = "Liver", .share = ball(middle(s), 6.0)}};
    for (const double mm : {1e3, 1e5}) {
        const auto sets = load(s, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, middle(s) + mm), {8, 8, 8});
        ASSERT_TRUE(sets) << sets.error().message;
        EXPECT_TRUE(sets->segments[0].voxels.isEmpty());
        EXPECT_TRUE(sets->segments[0].volumeMm3);
    }
}

// Each segment alone would fit on the fine grid, and is asked for in vain as they all do not.
TEST_F(SegmentVoxelsTest, WhatTakesMoreMemoryThanThereIsIsRefusedBeforeItIsTaken) {
    const auto available = availableMemory();
    ASSERT_TRUE(available);
    SyntheticSegmentation s = sheared();
    for (std::uint16_t number = 1; number <= 3; ++number)
        s.parts.push_back({.number = number, .label = "Liver", .share = ball(middle(s), 6.0)});
    constexpr double kSideMm = 4.0;  // within the ball
    const int side = int(std::cbrt(8.0 * 0.6 * double(*available)));
    const double stepMm = kSideMm / side;
    const glm::dmat4 fine = affine({stepMm, 0, 0}, {0, stepMm, 0}, {0, 0, stepMm}, middle(s) - 0.5 * kSideMm);
    const auto sets = load(s, fine, glm::ivec3(side));
    ASSERT_FALSE(sets);
    EXPECT_EQ(sets.error().code, ErrorCode::outOfMemory);
    EXPECT_NE(sets.error().message.english().find("GiB"), std::string::npos) << sets.error().message;
}

TEST_F(SegmentVoxelsTest, FractionsAreTheSegmentFromHalfOn) {
    SyntheticSegmentation s = sheared();
    const glm::dvec3 at = middle(s);
    s.type = "FRACTIONAL";
    s.parts = {{.number = 1, .label = "Liver", .share = [=](const glm::dvec3& mm) {
                    return std::max(0.0, 1.0 - glm::distance(mm, at) / 10.0);
                }}};
    const auto sets = load(s, s.worldFromVoxel, s.size);
    ASSERT_TRUE(sets) << sets.error().message;
    for (int k = 0; k < s.size.z; ++k) {
        const glm::dvec3 mm = transformPoint(s.worldFromVoxel, {10, 9, k});
        EXPECT_EQ(sets->segments[0].voxels.contains({10, 9, k}),
                  std::lround(200.0 * s.parts[0].share(mm)) >= 100)
            << k;
    }
}

// The marker of the phantom is a cube of known edge; the grid lies oblique to it, in the phantom's axes,
// three times as fine.
TEST_F(SegmentVoxelsTest, TheVolumeOfThePhantomsMarkerIsThatOfItsCube) {
    SyntheticSegmentation s;
    s.size = {64, 60, 48};
    const glm::dmat4 phantom = phantom::worldFromVoxel();
    s.worldFromVoxel = affine(glm::dvec3(phantom[0]) / 3.0, glm::dvec3(phantom[1]) / 3.0,
                              glm::dvec3(phantom[2]) / 3.0, glm::dvec3(0.0));
    s.worldFromVoxel[3] = glm::dvec4(phantom::markerCentreMm() + glm::dvec3(0.1, -0.05, 0.2) -
                                         transformVector(s.worldFromVoxel, 0.5 * glm::dvec3(s.size - 1)),
                                     1.0);
    s.parts = {{.number = 1, .label = "Marker", .share = [](const glm::dvec3& mm) {
                    const glm::dvec3 off = glm::abs(mm - phantom::markerCentreMm());
                    return std::max({off.x, off.y, off.z}) < phantom::markerHalfEdgeMm() ? 1.0 : 0.0;
                }}};
    const auto sets = load(s, s.worldFromVoxel, s.size);
    ASSERT_TRUE(sets) << sets.error().message;
    const double cubeMm3 = std::pow(2.0 * phantom::markerHalfEdgeMm(), 3);
    EXPECT_NEAR(*sets->segments[0].volumeMm3, cubeMm3, 0.01 * cubeMm3);
    EXPECT_LT(glm::distance(*sets->segments[0].centroidMm, phantom::markerCentreMm()), 0.1);
}

TEST_F(SegmentVoxelsTest, ACancelledOneTellsSo) {
    SyntheticSegmentation s = sheared();
    s.parts = {{.number = 1, .label = "Liver", .share = ball(middle(s), 6.0)}};
    writeSegmentation(folder_ / "seg", s);
    const auto header = readSegmentation(folder_ / "seg");
    ASSERT_TRUE(header);
    const CancelToken token;
    token.cancel();
    Progress progress({}, token);
    const auto sets = loadSegmentVoxels(*header, s.worldFromVoxel, s.size, progress);
    ASSERT_FALSE(sets);
    EXPECT_EQ(sets.error().code, ErrorCode::cancelled);
    Progress another;
    EXPECT_FALSE(loadSegmentVoxels(*header, glm::dmat4(0.0), s.size, another));
    EXPECT_FALSE(loadSegmentVoxels(*header, s.worldFromVoxel, {0, 1, 1}, another));
}

TEST(SegmentVoxels, OfARealOneAreThoseOfItsLabelMap) {
    SKIP_WITHOUT_SHARED_DATA();
    const auto header = readSegmentation(sharedData() / "odd/legacy_enhanced_pair/label.seg");
    ASSERT_TRUE(header) << header.error().message;
    const glm::dmat4 grid = affine({0.7, 0, 0}, {0, 0.7, 0}, {0, 0, 2.5}, {46.4649, 5.01881, -177.75});
    Progress progress;
    const auto map = loadSegmentation(*header, grid, {24, 38, 3}, progress);
    const auto sets = loadSegmentVoxels(*header, grid, {24, 38, 3}, progress);
    ASSERT_TRUE(map && sets);
    ASSERT_EQ(sets->segments.size(), 1u);
    std::size_t count = 0;
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 38; ++j)
            for (int i = 0; i < 24; ++i) {
                ASSERT_EQ(sets->segments[0].voxels.contains({i, j, k}), map->label(i, j, k) == 1);
                count += map->label(i, j, k) == 1 ? 1 : 0;
            }
    EXPECT_NEAR(*sets->segments[0].volumeMm3, double(count) * 0.7 * 0.7 * 2.5, 1e-6);
}

}  // namespace
}  // namespace macula::dicom::test
