// Metrics of frames against pictures made by hand.
#include "image/frame_metrics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace macula::image {
namespace {

constexpr int kWidth = 12;
constexpr int kHeight = 10;

Image picture(const std::function<double(int, int)>& value, int channels = 3, int width = kWidth) {
    Image image{
        .width = width, .height = kHeight, .channels = channels, .encoding = Encoding::display, .pixels = {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < width; ++x)
            image.pixels.insert(image.pixels.end(), std::size_t(channels), static_cast<float>(value(x, y)));
    return image;
}
Image grey(double value, int channels = 3) {
    return picture([=](int, int) { return value; }, channels);
}
Image broken() {
    Image image = grey(0.5);
    image.pixels[7] = std::numeric_limits<float>::quiet_NaN();
    return image;
}
Image linear() {
    Image image = grey(0.5);
    image.encoding = Encoding::linear;
    return image;
}

std::vector<float> weightsOf(const std::function<double(int, int)>& value) {
    std::vector<float> weights;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) weights.push_back(static_cast<float>(value(x, y)));
    return weights;
}
// 1 on the left, 0 on the right of the middle.
std::vector<float> hardWeights() {
    return weightsOf([](int x, int) { return x < 6 ? 1.0 : 0.0; });
}
// 1, then 0.75, 0.5, 0.25 in columns 5 to 7, then 0.
std::vector<float> softWeights() {
    return weightsOf([](int x, int) { return std::clamp(0.25 * (8 - x), 0.0, 1.0); });
}
Image step(double left, double right, int channels = 3) {
    return picture([=](int x, int) { return x < 6 ? left : right; }, channels);
}

// Both columns beside the step have half of it as their central difference.
TEST(SeamVisibility, OfAStepAtTheBorderIsLarge) {
    for (const int channels : {1, 3}) {
        const auto seam = *seamVisibility(grey(0.5, channels), step(0.5, 0.75, channels), hardWeights());
        ASSERT_TRUE(seam.has_value());
        EXPECT_NEAR(seam->frame, 0.125, 1e-12);
        EXPECT_NEAR(seam->reference, 0.0, 1e-12);
        EXPECT_NEAR(seam->ratio(), 0.125 * 255.0, 1e-9);
    }
    // Of the three columns of the soft border two are beside the step.
    const auto soft = *seamVisibility(grey(0.5), step(0.5, 0.75), softWeights());
    EXPECT_NEAR(soft->frame, 2.0 * 0.125 / 3.0, 1e-12);
}

TEST(SeamVisibility, OfAnIdenticalPictureIsOne) {
    const Image ripples = picture([](int x, int y) { return 0.5 + 0.3 * std::sin(x + 0.7 * y); });
    for (const Image& same : {grey(0.5), step(0.2, 0.9), ripples}) {
        EXPECT_EQ((*seamVisibility(same, same, hardWeights()))->ratio(), 1.0);
        EXPECT_EQ((*seamVisibility(same, same, softWeights()))->ratio(), 1.0);
    }
}

TEST(SeamVisibility, OfAnEdgeThatIsReallyThereIsOne) {
    // The same step elsewhere in brightness.
    const auto seam = *seamVisibility(step(0.25, 0.5), step(0.5, 0.75), hardWeights());
    EXPECT_NEAR(seam->ratio(), 1.0, 1e-12);
    EXPECT_NEAR(seam->reference, 0.125, 1e-12);
    // An edge that the frame blurs is no seam: less than 1.
    EXPECT_LT((*seamVisibility(step(0.25, 0.75), grey(0.5), hardWeights()))->ratio(), 0.1);
}

// What changes along the border, or away from it, is no border.
TEST(SeamVisibility, IsOfChangesAcrossTheBorder) {
    const Image along = picture([](int, int y) { return 0.1 * y; });
    const Image away = picture([](int x, int) { return x < 2 ? 0.0 : 1.0; });
    for (const Image& frame : {along, away}) {
        EXPECT_NEAR((*seamVisibility(grey(0.5), frame, hardWeights()))->frame, 0.0, 1e-7);
        EXPECT_NEAR((*seamVisibility(grey(0.5), frame, softWeights()))->frame, 0.0, 1e-7);
    }
    // Along a slanted border: the gradient (0.03, 0.04) of luminance across the normal (0.6, 0.8), and the
    // part of (0.05, 0) that is along it.
    const auto slanted = weightsOf([](int x, int y) { return 0.1 + 0.8 * (0.6 * x + 0.8 * y) / 16.0; });
    const Image steep = picture([](int x, int y) { return 0.03 * x + 0.04 * y; });
    EXPECT_NEAR((*seamVisibility(grey(0.5), steep, slanted))->frame, 0.05, 1e-6);
    const Image aside = picture([](int x, int) { return 0.05 * x; });
    EXPECT_NEAR((*seamVisibility(grey(0.5), aside, slanted))->frame, 0.03, 1e-6);
}

// A step beside the border is seen by the column on its side alone, with half of its height.
TEST(SeamVisibility, IsOfBothSidesOfAHardBorder) {
    const Image inside = picture([](int x, int) { return x < 5 ? 0.25 : 0.75; });  // between columns 4 and 5
    EXPECT_NEAR((*seamVisibility(grey(0.5), inside, hardWeights()))->frame, 0.25 / 2.0, 1e-12);
    const Image outside = picture([](int x, int) { return x < 7 ? 0.25 : 0.75; });
    EXPECT_NEAR((*seamVisibility(grey(0.5), outside, hardWeights()))->frame, 0.25 / 2.0, 1e-12);
    // Above and below.
    const Image lying = picture([](int, int y) { return y < 5 ? 0.5 : 0.75; });
    const auto weights = weightsOf([](int, int y) { return y < 5 ? 0.0 : 1.0; });
    EXPECT_NEAR((*seamVisibility(grey(0.5), lying, weights))->frame, 0.125, 1e-12);
}

// Red, green and blue count as in Rec. 709.
TEST(SeamVisibility, IsOfLuminance) {
    Image frame = grey(0.5);
    for (std::size_t i = 0; i < std::size_t(kWidth * kHeight); ++i)
        if (i % kWidth >= 6) frame.pixels[3 * i + 1] = 0.75f;  // green
    EXPECT_NEAR((*seamVisibility(grey(0.5), frame, hardWeights()))->frame, 0.125 * 0.7152, 1e-9);
}

TEST(SeamVisibility, WithoutABorderIsNothing) {
    const Image frame = step(0.2, 0.8);
    for (const double weight : {0.0, 0.02, 0.98, 1.0, 1.5, -1.0}) {
        const auto flat = weightsOf([=](int, int) { return weight; });
        EXPECT_FALSE(seamVisibility(grey(0.5), frame, flat)->has_value()) << weight;
    }
    // A plateau has no normal; what is near 0 or near 1 is no border.
    EXPECT_FALSE(seamVisibility(grey(0.5), frame, weightsOf([](int, int) { return 0.5; }))->has_value());
    const auto nearlyOne = weightsOf([](int x, int) { return x < 6 ? 1.0 : 0.99; });
    EXPECT_FALSE(seamVisibility(grey(0.5), frame, nearlyOne)->has_value());
    const auto nearlyZero = weightsOf([](int x, int) { return x < 6 ? 0.01 : 0.0; });
    EXPECT_FALSE(seamVisibility(grey(0.5), frame, nearlyZero)->has_value());
}

// A flat reference is as one step of 8 bits per pixel; so is a frame, or equal flat ones would differ.
TEST(SeamVisibility, HasAFloorOfOneStepPerPixel) {
    EXPECT_EQ((SeamVisibility{.frame = 0.0, .reference = 0.0}.ratio()), 1.0);
    EXPECT_NEAR((SeamVisibility{.frame = 2.0 / 255.0, .reference = 0.0}.ratio()), 2.0, 1e-12);
    EXPECT_NEAR((SeamVisibility{.frame = 0.0, .reference = 2.0 / 255.0}.ratio()), 0.5, 1e-12);
    EXPECT_EQ((SeamVisibility{.frame = 0.9 / 255.0, .reference = 0.1 / 255.0}.ratio()), 1.0);
}

TEST(SeamVisibility, RefusesWhatCannotBeCompared) {
    const auto refused = [](const Image& reference, const Image& frame, const std::vector<float>& weights) {
        const auto seam = seamVisibility(reference, frame, weights);
        return !seam.ok() && seam.error().code == ErrorCode::usage;
    };
    const Image narrow = picture([](int, int) { return 0.5; }, 3, 11);
    for (const Image& wrong : {Image{}, narrow, grey(0.5, 1), linear(), broken()}) {
        EXPECT_TRUE(refused(grey(0.5), wrong, hardWeights()));
        EXPECT_TRUE(refused(wrong, grey(0.5), hardWeights()));
    }
    auto weights = hardWeights();
    weights[3] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(refused(grey(0.5), grey(0.5), weights));
    weights.pop_back();
    EXPECT_TRUE(refused(grey(0.5), grey(0.5), weights));
    EXPECT_TRUE(refused(grey(0.5), grey(0.5), {}));
}

TEST(Flicker, IsTheMeanDifferenceWhereItIsKnown) {
    const Mask all(kWidth * kHeight, 1);
    for (const int channels : {1, 3}) {
        const Image before = grey(0.5, channels);
        const Image frame = step(0.75, 0.375, channels);
        EXPECT_NEAR(**flicker(before, frame, all), (0.25 + 0.125) / 2.0, 1e-12);
        EXPECT_NEAR(**flicker(frame, before, all), (0.25 + 0.125) / 2.0, 1e-12);
        Mask left(all.size());
        for (std::size_t i = 0; i < left.size(); ++i) left[i] = i % kWidth < 6 ? 255 : 0;
        EXPECT_NEAR(**flicker(before, frame, left), 0.25, 1e-12);
        EXPECT_EQ(**flicker(frame, frame, all), 0.0);
        EXPECT_FALSE(flicker(before, frame, Mask(all.size(), 0))->has_value());
    }
    Image blue = grey(0.5);
    for (std::size_t i = 2; i < blue.pixels.size(); i += 3) blue.pixels[i] = 1.0f;
    EXPECT_NEAR(**flicker(grey(0.5), blue, all), 0.5 * 0.0722, 1e-9);
}

TEST(Flicker, RefusesWhatCannotBeCompared) {
    const Mask all(kWidth * kHeight, 1);
    for (const Image& wrong : {Image{}, grey(0.5, 1), linear(), broken()}) {
        EXPECT_EQ(flicker(grey(0.5), wrong, all).error().code, ErrorCode::usage);
        EXPECT_EQ(flicker(wrong, grey(0.5), all).error().code, ErrorCode::usage);
    }
    EXPECT_EQ(flicker(grey(0.5), grey(0.5), Mask(7, 1)).error().code, ErrorCode::usage);
}

// Masks of foveas against angles worked out by hand.

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
