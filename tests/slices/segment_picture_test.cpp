// Segments lie over exactly the pixels of their voxels, however the volume and the plane lie.
#include "slices/segment_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "slices/made_volumes.h"
#include "slices/sampled_slice.h"

namespace macula::slices {
namespace {

constexpr glm::ivec3 kSize{17, 13, 11};

Volume flat(const glm::dmat4& worldFromVoxel) {
    return test::volumeOf(kSize, worldFromVoxel,
                          std::vector<float>(std::size_t(kSize.x * kSize.y * kSize.z), 1.0f));
}

std::shared_ptr<const VoxelSet> randomSet(test::Random& random, const glm::ivec3& low,
                                          const glm::ivec3& high) {
    VoxelSet set(low, high);
    for (int k = low.z; k <= high.z; ++k)
        for (int j = low.y; j <= high.y; ++j)
            for (int i = low.x; i <= high.x; ++i)
                if (random() % 3 != 0) set.add({i, j, k});
    return std::make_shared<const VoxelSet>(std::move(set));
}

// Between two voxels rounding decides.
bool isAtBorder(const Volume& volume, const glm::dvec3& mm) {
    const glm::dvec3 at = transformPoint(glm::inverse(volume.worldFromVoxel()), mm);
    const glm::dvec3 off = glm::abs(at - glm::floor(at) - 0.5);
    return std::min({off.x, off.y, off.z}) < 1e-5;
}

bool isIn(const Volume& volume, const VoxelSet& set, const glm::dvec3& mm) {
    const auto at = probe(volume, mm);
    return at && set.contains(at->voxel);
}

unsigned alphaAt(const SegmentPicture& picture, int x, int y) {
    if (picture.argb.empty()) return 0;
    return picture.argb[std::size_t(y) * std::size_t(picture.sizePx.x) + std::size_t(x)] >> 24;
}

TEST(SegmentPicture, IsThatOfTheNearestVoxelsInEveryPose) {
    test::Random random(1);
    for (const test::Pose& pose : test::poses()) {
        SCOPED_TRACE(pose.name);
        const Volume volume = flat(pose.worldFromVoxel);
        const ShownSegments segments{{.voxels = randomSet(random, {2, 1, 0}, {12, 12, 9}),
                                      .label = "a",
                                      .rgb = {255, 0, 0},
                                      .opacity = 0.5}};
        const double mm = volume.worldBox().diagonal() / 60.0;
        for (int n = 0; n < 4; ++n) {
            const glm::dvec3 centre = test::middleMm(volume);
            const SliceFrame frame{
                .plane = n == 0 ? acquiredPlane(volume, centre) : test::randomPlane(centre, random),
                .mmPerPixel = mm,
                .sizePx = {64, 56}};
            const SegmentPicture picture = paintSegments(volume, frame, segments, 1);
            int seen = 0;
            for (int y = 0; y < frame.sizePx.y; ++y) {
                for (int x = 0; x < frame.sizePx.x; ++x) {
                    const glm::dvec3 at = frame.worldFromPicture({x + 0.5, y + 0.5});
                    if (isAtBorder(volume, at)) continue;
                    const bool isExpected = isIn(volume, *segments[0].voxels, at);
                    ASSERT_EQ(alphaAt(picture, x, y) > 0, isExpected) << n << ": " << x << ' ' << y;
                    ASSERT_EQ(segmentsAt(volume, at, segments).size(), isExpected ? 1u : 0u);
                    seen += isExpected ? 1 : 0;
                }
            }
            EXPECT_GT(seen, 20);
        }
    }
}

TEST(SegmentPicture, TheLineLiesWithinAlongTheBorder) {
    const Volume volume = flat(affine({2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {0, 0, 0}));
    VoxelSet set({4, 4, 5}, {7, 6, 5});
    for (int j = 4; j <= 6; ++j)
        for (int i = 4; i <= 7; ++i) set.add({i, j, 5});
    const ShownSegments segments{{.voxels = std::make_shared<const VoxelSet>(set),
                                  .label = "a",
                                  .rgb = {10, 200, 30},
                                  .opacity = 0.0}};
    // Four pixels a voxel; the upper left corner of the picture is that of voxel (0, 0).
    const SliceFrame frame{.plane = {.centreMm = {16.0, 12.0, 10.0}}, .mmPerPixel = 0.5, .sizePx = {68, 52}};
    for (const int width : {1, 2}) {
        const SegmentPicture picture = paintSegments(volume, frame, segments, width);
        for (int y = 0; y < 52; ++y) {
            for (int x = 0; x < 68; ++x) {
                const bool isInside = x >= 16 && x < 32 && y >= 16 && y < 28;
                const bool isMiddle = x >= 16 + width && x < 32 - width && y >= 16 + width && y < 28 - width;
                ASSERT_EQ(alphaAt(picture, x, y), isInside && !isMiddle ? 255u : 0u) << x << ' ' << y;
            }
        }
        EXPECT_EQ(picture.argb[16 * 68 + 16], 0xFF0AC81Eu);
    }
    // Cut by the side of the picture, it has no line there.
    const SliceFrame part{.plane = {.centreMm = {16.0, 12.0, 10.0}}, .mmPerPixel = 0.5, .sizePx = {20, 8}};
    const SegmentPicture cut = paintSegments(volume, part, segments, 1);
    EXPECT_EQ(alphaAt(cut, 0, 4), 0u) << "in the middle of the segment";
}

TEST(SegmentPicture, LaterOnesLieOverEarlierOnes) {
    const Volume volume = flat(affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}));
    const auto boxOf = [](const glm::ivec3& low, const glm::ivec3& high) {
        VoxelSet set(low, high);
        for (int j = low.y; j <= high.y; ++j)
            for (int i = low.x; i <= high.x; ++i) set.add({i, j, low.z});
        return std::make_shared<const VoxelSet>(std::move(set));
    };
    ShownSegments segments{{.voxels = boxOf({1, 1, 5}, {12, 10, 5}), .label = "a", .rgb = {200, 0, 0}},
                           {.voxels = boxOf({4, 1, 5}, {14, 10, 5}), .label = "b", .rgb = {0, 0, 100}}};
    segments[0].opacity = 1.0;
    segments[1].opacity = 0.5;
    const SliceFrame frame{.plane = {.centreMm = {8.0, 6.0, 5.0}}, .mmPerPixel = 1.0, .sizePx = {17, 13}};
    const SegmentPicture picture = paintSegments(volume, frame, segments, 1);
    const std::uint32_t both = picture.argb[5 * 17 + 8];
    EXPECT_EQ(both >> 24, 255u);
    EXPECT_NEAR(double(both >> 16 & 0xFF), 100.0, 1.0);
    EXPECT_NEAR(double(both & 0xFF), 50.0, 1.0);
    EXPECT_EQ(picture.argb[5 * 17 + 13] >> 24, 128u) << "half, of one alone";
    EXPECT_EQ(segmentsAt(volume, {8.0, 5.0, 5.0}, segments), (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(segmentsAt(volume, {13.0, 5.0, 5.0}, segments), std::vector<std::size_t>{1});
    EXPECT_TRUE(segmentsAt(volume, {1e4, 5.0, 5.0}, segments).empty());
}

TEST(SegmentPicture, OfNothingIsEmpty) {
    const Volume volume = flat(affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}));
    VoxelSet one({3, 3, 3}, {3, 3, 3});
    one.add({3, 3, 3});
    const ShownSegments segments{{.voxels = std::make_shared<const VoxelSet>(one), .label = {}},
                                 {.voxels = std::make_shared<const VoxelSet>(), .label = {}},
                                 {.voxels = nullptr, .label = {}}};
    SliceFrame frame{.plane = {.centreMm = {8.0, 6.0, 3.0}}, .mmPerPixel = 1.0, .sizePx = {17, 13}};
    EXPECT_FALSE(paintSegments(volume, frame, segments, 1).argb.empty());
    EXPECT_TRUE(paintSegments(volume, frame, {}, 1).argb.empty());
    EXPECT_TRUE(paintSegments(volume, frame, segments, 1, [] { return true; }).argb.empty());
    frame.plane.centreMm.z = 5.0;
    EXPECT_TRUE(paintSegments(volume, frame, segments, 1).argb.empty());
    frame.mmPerPixel = std::nan("");
    EXPECT_TRUE(paintSegments(volume, frame, segments, 1).argb.empty());
    frame.sizePx = {0, 10};
    EXPECT_TRUE(paintSegments(volume, frame, segments, 1).argb.empty());
}

}  // namespace
}  // namespace macula::slices
