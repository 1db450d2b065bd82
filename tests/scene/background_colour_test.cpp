#include "scene/lights/background_colour.h"

#include <gtest/gtest.h>

#include "base/srgb.h"
#include "pictures/covering_picture.h"

namespace macula::scene {
namespace {

TEST(BackgroundColour, IsANameOrSixDigits) {
    EXPECT_EQ(backgroundOf("black").value(), BackgroundColour(0, 0, 0));
    EXPECT_EQ(backgroundOf("white").value(), BackgroundColour(255, 255, 255));
    EXPECT_EQ(backgroundOf("grey").value(), BackgroundColour(128, 128, 128));
    EXPECT_EQ(backgroundOf("#0a1fFF").value(), BackgroundColour(10, 31, 255));
    for (const char* wrong : {"", "White", "#fff", "#12345", "#1234567", "123456", "#12345g", "#-12345",
                              "# 12345", "transparent", "1,1,1"}) {
        const Result<BackgroundColour> colour = backgroundOf(wrong);
        ASSERT_FALSE(colour.ok()) << wrong;
        EXPECT_EQ(colour.error().code, ErrorCode::usage);
        EXPECT_NE(colour.error().hint.english().find("#rrggbb"), std::string::npos);
    }
}

TEST(BackgroundColour, ComesBackFromItsText) {
    for (int i = 0; i < 256; ++i) {
        const BackgroundColour colour(i, 255 - i, (7 * i) % 256);
        EXPECT_EQ(colourOfHex(hexOf(colour)), colour);
    }
    EXPECT_EQ(hexOf({1, 2, 255}), "#0102ff");
}

TEST(BackgroundColour, IsLightThatEncodesToItself) {
    for (int i = 0; i < 256; ++i) {
        const glm::vec3 light = lightOf(BackgroundColour(i));
        EXPECT_EQ(std::lround(255.0f * encodedSrgb(light.g)), i);
    }
}

// A pixel of straight colour c and coverage a over both backgrounds, as the display mixes: in linear light.
std::vector<std::uint8_t> over(double background, const glm::dvec3& colour, double coverage) {
    std::vector<std::uint8_t> rgba;
    for (int channel = 0; channel < 3; ++channel)
        rgba.push_back(std::uint8_t(
            std::lround(255.0 * encodedSrgb(coverage * colour[channel] + (1.0 - coverage) * background))));
    rgba.push_back(255);
    return rgba;
}

TEST(CoveringPicture, FindsColourAndCoverage) {
    for (const double coverage : {1.0, 0.9, 0.5, 0.2}) {
        for (const glm::dvec3& colour :
             {glm::dvec3(0.5, 0.2, 0.1), glm::dvec3(0.05), glm::dvec3(0.9, 0.9, 0.1)}) {
            const auto rgba =
                pictures::coveringPicture(over(0.0, colour, coverage), over(1.0, colour, coverage));
            EXPECT_NEAR(rgba[3] / 255.0, coverage, 0.02) << coverage;
            for (std::size_t channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(rgba[channel] / 255.0, encodedSrgb(colour[int(channel)]), 0.03) << coverage;
        }
    }
}

TEST(CoveringPicture, IsExactWhereAllOrNothingIsCovered) {
    const std::vector<std::uint8_t> opaque{12, 200, 255, 255};
    EXPECT_EQ(pictures::coveringPicture(opaque, opaque), opaque);
    const std::vector<std::uint8_t> black{0, 0, 0, 255};
    const std::vector<std::uint8_t> white{255, 255, 255, 255};
    EXPECT_EQ(pictures::coveringPicture(black, white), std::vector<std::uint8_t>(4, 0));
    EXPECT_EQ(pictures::coveringPicture(black, black), black) << "black matter covers";
    EXPECT_EQ(pictures::coveringPicture(white, white), white);
    EXPECT_TRUE(pictures::coveringPicture({}, {}).empty());
}

}  // namespace
}  // namespace macula::scene
