// Edges, lines and dots in pictures made by hand.
#include "image/edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

namespace macula::image {
namespace {

constexpr int kWidth = 12;
constexpr int kHeight = 10;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

Image picture(const std::function<double(int, int)>& value, int channels = 3) {
    Image image{.width = kWidth,
                .height = kHeight,
                .channels = channels,
                .encoding = Encoding::display,
                .pixels = {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            image.pixels.insert(image.pixels.end(), std::size_t(channels), static_cast<float>(value(x, y)));
    return image;
}
Image grey(double value) {
    return picture([=](int, int) { return value; });
}
// Bright on the left.
Image halves(double left, double right) {
    return picture([=](int x, int) { return x < 6 ? left : right; });
}
// The same with one pixel of another value.
Image dotted(const Image& image, int x, int y, float value) {
    Image with = image;
    for (int c = 0; c < 3; ++c) with.pixels[std::size_t(3 * (y * kWidth + x) + c)] = value;
    return with;
}
std::vector<float> coverageOf(const std::function<double(int, int)>& value) {
    std::vector<float> coverage;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) coverage.push_back(static_cast<float>(value(x, y)));
    return coverage;
}
Mask all() {
    return Mask(std::size_t(kWidth * kHeight), 1);
}
Mask silhouetteOfHalves() {
    return silhouetteMask(coverageOf([](int x, int) { return x < 6 ? 1.0 : 0.0; }), kWidth, kHeight);
}

TEST(SilhouetteMask, IsAPixelWideOnBothSidesOfWhereHalfIsCovered) {
    const Mask mask = silhouetteOfHalves();
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            EXPECT_EQ(mask[std::size_t(y * kWidth + x)], x == 5 || x == 6 ? 1 : 0) << x << ' ' << y;
}

TEST(SilhouetteMask, NothingHasNoneAndWhatIsNoNumberCoversNothing) {
    for (const double even : {0.0, 0.49, 0.5, 1.0, 1e30}) {
        const Mask mask = silhouetteMask(coverageOf([=](int, int) { return even; }), kWidth, kHeight);
        EXPECT_EQ(std::count(mask.begin(), mask.end(), 1), 0) << even;
    }
    std::vector<float> coverage = coverageOf([](int, int) { return 1.0; });
    coverage[std::size_t(4 * kWidth + 4)] = kNaN;
    const Mask mask = silhouetteMask(coverage, kWidth, kHeight);
    EXPECT_EQ(std::count(mask.begin(), mask.end(), 1), 9);
    EXPECT_TRUE(silhouetteMask({}, 0, 0).empty());
}

TEST(MixedMask, IsOfWeightsThatAreNeitherNoneNorAll) {
    EXPECT_EQ(mixedMask(std::vector<float>{0.0f, 0.02f, 0.03f, 0.5f, 0.97f, 0.98f, 1.0f, kNaN}),
              (Mask{0, 0, 1, 1, 1, 0, 0, 0}));
}

TEST(EdgeVisibility, OfTheSamePictureIsOne) {
    const auto edges = *edgeVisibility(halves(0.8, 0.2), halves(0.8, 0.2), silhouetteOfHalves());
    ASSERT_TRUE(edges.has_value());
    EXPECT_EQ(edges->meanRatio(), 1.0);
    EXPECT_EQ(edges->mostRatio(), 1.0);
    EXPECT_NEAR(edges->frame.mean, 0.6, 1e-7);
}

// A frame that is bright up to the edge and black beside it, where the truth is dark grey there.
TEST(EdgeVisibility, ALineMakesTheEdgeSteeper) {
    const Image lined = picture([](int x, int) { return x < 6 ? 0.8 : x == 6 ? 0.0 : 0.6; });
    const auto edges = *edgeVisibility(halves(0.8, 0.6), lined, silhouetteOfHalves());
    EXPECT_NEAR(edges->meanRatio(), 4.0, 1e-5);
    EXPECT_NEAR(edges->mostRatio(), 4.0, 1e-5);
}

// A dot is seen in the percentile, if hardly in the mean; central differences would be 0 at it.
TEST(EdgeVisibility, ADotIsSeenInTheMost) {
    const Image truth = grey(0.5);
    const auto edges = *edgeVisibility(truth, dotted(truth, 6, 5, 0.0f), silhouetteOfHalves());
    EXPECT_NEAR(edges->mostRatio(), 0.5 * 255.0, 3.0);
    EXPECT_LT(edges->meanRatio(), 0.25 * edges->mostRatio());
}

// The two largest of 2 000 steps do not count.
TEST(EdgeVisibility, TheMostIsThe999thOfAThousand) {
    const auto most = [](int dots) {
        Image image{.width = 2000, .height = 2, .channels = 1, .encoding = Encoding::display, .pixels = {}};
        image.pixels.assign(4000, 0.5f);
        Mask mask(4000, 0);
        for (int x = 0; x < 2000; ++x) mask[std::size_t(x)] = 1;
        // Below the mask, so that each dot is beside one pixel of it.
        for (int d = 0; d < dots; ++d) image.pixels[std::size_t(2000 + 100 * d)] = 1.0f;
        return (*edgeVisibility(image, image, mask))->frame.most;
    };
    EXPECT_EQ(most(1), 0.0);
    EXPECT_NEAR(most(3), 0.5, 1e-7);
}

TEST(EdgeVisibility, NothingIsSaidOfNoPixelsAndWrongMasksAreRefused) {
    EXPECT_FALSE(edgeVisibility(grey(0.5), grey(0.5), Mask(all().size(), 0))->has_value());
    EXPECT_EQ(edgeVisibility(grey(0.5), grey(0.5), Mask(3, 1)).error().code, ErrorCode::usage);
    EXPECT_EQ(edgeVisibility(grey(0.5), picture([](int, int) { return 0.5; }, 1), all()).error().code,
              ErrorCode::usage);
    Image broken = grey(0.5);
    broken.pixels[7] = kNaN;
    EXPECT_EQ(edgeVisibility(grey(0.5), broken, all()).error().code, ErrorCode::usage);
}

TEST(DarkerThanBoth, CountsDotsThatNeitherSourceHasNearby) {
    const Image bright = grey(0.8);
    const Image dark = grey(0.5);
    EXPECT_EQ(*darkerThanBoth(dotted(bright, 3, 3, 0.3f), bright, dark, all(), 0.02), 1u);
    EXPECT_EQ(*darkerThanBoth(dotted(bright, 3, 3, 0.49f), bright, dark, all(), 0.02), 0u);  // the margin
    EXPECT_EQ(*darkerThanBoth(dotted(bright, 3, 3, 0.3f), bright, dotted(dark, 4, 4, 0.3f), all(), 0.02), 0u);
    Mask elsewhere = all();
    elsewhere[std::size_t(3 * kWidth + 3)] = 0;
    EXPECT_EQ(*darkerThanBoth(dotted(bright, 3, 3, 0.3f), bright, dark, elsewhere, 0.02), 0u);
    EXPECT_EQ(darkerThanBoth(bright, bright, dark, Mask(1, 1), 0.02).error().code, ErrorCode::usage);
}

}  // namespace
}  // namespace macula::image
