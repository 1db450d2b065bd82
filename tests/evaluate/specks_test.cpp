// What counts as a speck.
#include "evaluate/specks.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace macula::evaluate {
namespace {

image::Image grey(int width, int height, float encoded) {
    return {.width = width,
            .height = height,
            .channels = 3,
            .encoding = image::Encoding::display,
            .pixels = std::vector<float>(std::size_t(width) * std::size_t(height) * 3, encoded)};
}

void put(image::Image& image, int x, int y, float encoded) {
    for (int channel = 0; channel < 3; ++channel)
        image
            .pixels[3 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) + std::size_t(channel)] =
            encoded;
}

TEST(SpecksOf, APictureIsFreeOfThemBesideItself) {
    image::Image picture = grey(9, 7, 0.5f);
    put(picture, 3, 3, 1.0f);  // what converges to a bright dot is none
    const Specks specks = specksOf(picture, picture);
    EXPECT_EQ(specks.bright, 0u);
    EXPECT_EQ(specks.dark, 0u);
    EXPECT_EQ(specks.pixels, 63u);
    EXPECT_DOUBLE_EQ(specks.lightRatio, 1.0);
}

TEST(SpecksOf, CountsBrightAndDarkOnes) {
    const image::Image converged = grey(9, 7, 0.5f);
    image::Image shown = converged;
    put(shown, 0, 0, 0.6f);    // linear light grows by more than half
    put(shown, 5, 5, 0.505f);  // by a fiftieth
    put(shown, 8, 6, 0.4f);
    const Specks specks = specksOf(shown, converged);
    EXPECT_EQ(specks.bright, 1u);
    EXPECT_EQ(specks.dark, 1u);
    EXPECT_NEAR(specks.worst, 0.31855 / 0.21404, 1e-4);  // of linear light
}

TEST(SpecksOf, TheConvergedNeighboursOfTwoPixelsAllowIt) {
    image::Image converged = grey(9, 9, 0.5f);
    put(converged, 2, 4, 0.9f);
    image::Image shown = grey(9, 9, 0.5f);
    put(shown, 4, 4, 0.9f);  // two pixels beside
    EXPECT_EQ(specksOf(shown, converged).bright, 0u);
    put(shown, 4, 4, 0.5f);
    put(shown, 5, 4, 0.9f);  // three
    EXPECT_EQ(specksOf(shown, converged).bright, 1u);
}

TEST(SpecksOf, AStepOfEightBitsIsNoSpeck) {
    const image::Image black = grey(5, 5, 0.0f);
    image::Image shown = black;
    put(shown, 2, 2, 1.0f / 255.0f);
    EXPECT_EQ(specksOf(shown, black).bright, 0u);
    put(shown, 2, 2, 3.0f / 255.0f);
    EXPECT_EQ(specksOf(shown, black).bright, 1u);
    EXPECT_EQ(specksOf(black, black).pixels, 0u);
}

TEST(SpecksOptions, AscendBelowTheConvergedPicture) {
    EXPECT_TRUE(check({}, SpecksOptions{}).ok());
    for (const std::vector<std::uint32_t>& samples :
         {std::vector<std::uint32_t>{2, 1}, {0, 1}, {4, 4}, {1, 64}})
        EXPECT_EQ(check({}, SpecksOptions{.samples = samples, .convergedSamples = 64}).error().code,
                  ErrorCode::usage);
}

}  // namespace
}  // namespace macula::evaluate
