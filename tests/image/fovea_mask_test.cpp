// Masks of foveas against angles worked out by hand.
#include "image/frame_metrics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace macula::image {
namespace {

constexpr double kDegrees = 57.29577951308232;

// 20 pixels of 90 degrees are 2 high at a distance of 1: 0.1 each.
TEST(FoveaMask, OfTheMiddleIsADisc) {
    const FoveaInPicture fovea{
        .sizePx = {20, 20}, .verticalFovDeg = 90.0, .fieldDeg = 2.0 * kDegrees * std::atan(0.52)};
    const Mask mask = *foveaMask(fovea);
    ASSERT_EQ(mask.size(), 400u);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x)
            EXPECT_EQ(mask[std::size_t(20 * y + x)] != 0, std::hypot(x - 9.5, y - 9.5) <= 5.2)
                << x << " " << y;
}

// A gaze at the middle of the pixel in column 17, row 2: a field of next to nothing is that pixel.
TEST(FoveaMask, IsWhereTheGazeIs) {
    const Mask mask =
        *foveaMask({.sizePx = {20, 10}, .verticalFovDeg = 40.0, .gaze = {0.75, 0.5}, .fieldDeg = 0.01});
    EXPECT_EQ(std::count(mask.begin(), mask.end(), 1), 1);
    EXPECT_EQ(mask[2 * 20 + 17], 1);
}

// The eye sees pixels aside under smaller angles. In the plane at a distance of 1, middles are 0.1 apart
// along one row: that of the gaze at 0.75 is at 36.87 degrees. 10 degrees to both sides reach from 0.5059
// to 1.0661.
TEST(FoveaMask, IsAnAngleAndNoDisc) {
    const FoveaInPicture aside{.sizePx = {40, 1},
                               .verticalFovDeg = 2.0 * kDegrees * std::atan(0.05),
                               .gaze = {0.375, 0.0},
                               .fieldDeg = 20.0};
    const Mask mask = *foveaMask(aside);
    for (int x = 0; x < 40; ++x) {
        const double place = 0.1 * (x + 0.5) - 2.0;
        EXPECT_EQ(mask[std::size_t(x)] != 0, place > 0.5059 && place < 1.0661) << x;
    }
    EXPECT_EQ(std::count(mask.begin(), mask.end(), 1), 6);  // 0.55 to 1.05
}

TEST(FoveaMask, HasExtremes) {
    const Mask none = *foveaMask({.sizePx = {20, 20}, .verticalFovDeg = 90.0, .fieldDeg = 0.01});
    EXPECT_EQ(std::count(none.begin(), none.end(), 1), 0);  // between four pixels
    const Mask all = *foveaMask({.sizePx = {20, 20}, .verticalFovDeg = 90.0, .fieldDeg = 180.0});
    EXPECT_EQ(std::count(all.begin(), all.end(), 1), 400);
    EXPECT_EQ(*foveaMask({.sizePx = {1, 1}, .verticalFovDeg = 90.0, .fieldDeg = 1.0}), Mask{1});
}

TEST(FoveaMask, RefusesWhatIsNoFovea) {
    const FoveaInPicture good{
        .sizePx = {20, 10}, .verticalFovDeg = 40.0, .gaze = {1.0, -1.0}, .fieldDeg = 20.0};
    EXPECT_TRUE(foveaMask(good).ok());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refused = [&](const auto& change) {
        FoveaInPicture wrong = good;
        change(wrong);
        const auto mask = foveaMask(wrong);
        return !mask.ok() && mask.error().code == ErrorCode::usage;
    };
    EXPECT_TRUE(refused([](FoveaInPicture& f) { f.sizePx.x = 0; }));
    EXPECT_TRUE(refused([](FoveaInPicture& f) { f.sizePx.y = -1; }));
    for (const double wrong : {nan, 0.0, 180.5}) {
        EXPECT_TRUE(refused([=](FoveaInPicture& f) { f.verticalFovDeg = wrong; }));
        EXPECT_TRUE(refused([=](FoveaInPicture& f) { f.fieldDeg = wrong; }));
    }
    for (const double wrong : {nan, -1.01, 1.01}) {
        EXPECT_TRUE(refused([=](FoveaInPicture& f) { f.gaze.x = wrong; }));
        EXPECT_TRUE(refused([=](FoveaInPicture& f) { f.gaze.y = wrong; }));
    }
}

}  // namespace
}  // namespace macula::image
