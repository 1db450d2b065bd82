#include "slices/colour_table.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace macula::slices {
namespace {

constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

DisplayWindow upTo(double high) {
    return {.center = 0.5 * high, .width = high, .explanation = {}, .function = "LINEAR_EXACT"};
}

TEST(ColourTable, HotIronIsAsInTheStandard) {
    // PS3.6 B.1.1: red rises first, then green from the middle, then blue from three quarters.
    EXPECT_EQ(colourOf(ColourTable::hotIron, 0), (Rgb{0, 0, 0}));
    EXPECT_EQ(colourOf(ColourTable::hotIron, 64), (Rgb{128, 0, 0}));
    EXPECT_EQ(colourOf(ColourTable::hotIron, 128), (Rgb{255, 0, 0}));
    EXPECT_EQ(colourOf(ColourTable::hotIron, 192), (Rgb{255, 128, 0}));
    EXPECT_EQ(colourOf(ColourTable::hotIron, 255), (Rgb{255, 254, 252}));
    EXPECT_EQ(colourOf(ColourTable::green, 77), (Rgb{0, 77, 0}));
    EXPECT_EQ(colourOf(ColourTable::grey, 77), (Rgb{77, 77, 77}));
}

TEST(ColourTable, WhereThereIsNoValueOrNoUptakeNothingIsHidden) {
    const std::vector<float> values{kNoValue, 0.0F, 10.0F};
    const auto pixels = toColours(values, upTo(10.0), false, ColourTable::hotIron, 1.0);
    EXPECT_EQ(pixels, (std::vector<std::uint32_t>{0U, 0U, 0xFFFFFEFCU}));
    const auto grey = toColours(values, upTo(10.0), false, ColourTable::grey, 1.0);
    EXPECT_EQ(grey, (std::vector<std::uint32_t>{0U, 0xFF000000U, 0xFFFFFFFFU})) << "grey hides all";
    EXPECT_EQ(toColours(values, upTo(10.0), true, ColourTable::grey, 1.0),
              (std::vector<std::uint32_t>{0U, 0xFFFFFFFFU, 0xFF000000U}));
    EXPECT_TRUE(toColours({}, upTo(10.0), false, ColourTable::grey, 1.0).empty());
}

TEST(ColourTable, ColoursArePremultipliedAndOpacityHasEnds) {
    const std::vector<float> values{10.0F};
    const auto at = [&](double opacity) {
        return toColours(values, upTo(10.0), false, ColourTable::green, opacity)[0];
    };
    EXPECT_EQ(at(0.5), 0x80008000U);
    EXPECT_EQ(at(0.0), 0U);
    EXPECT_EQ(at(-3.0), 0U);
    EXPECT_EQ(at(7.0), 0xFF00FF00U);
    EXPECT_EQ(at(std::numeric_limits<double>::quiet_NaN()), 0U);
}

}  // namespace
}  // namespace macula::slices
