// How images are shown: tables, windows, inversion, and what is no number.
#include "study/planar/planar_display.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace macula::study {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
using Bytes = std::vector<std::uint8_t>;

dicom::PlanarFrame greyOf(std::vector<float> values) {
    return {.columns = int(values.size()), .rows = 1, .values = std::move(values), .rgb = {}};
}

dicom::PlanarHeader withTable(std::vector<std::uint16_t> entries, int bits, int firstMapped = 0) {
    dicom::PlanarHeader header;
    header.tables.push_back(
        {std::make_shared<dicom::ModalityLut>(dicom::ModalityLut{firstMapped, std::move(entries)}), bits,
         ""});
    return header;
}

PlanarDisplay byWindow(double center, double width) {
    PlanarDisplay display;
    display.window = {.center = center, .width = width, .explanation = {}, .function = "LINEAR_EXACT"};
    return display;
}

TEST(PlanarDisplays, AWindowMakesGreyAndMonochrome1IsItsNegative) {
    const dicom::PlanarFrame pixels = greyOf({-1000, 0, 50, 100, 1e30F, kNan, kInfinity, -kInfinity});
    dicom::PlanarHeader header;
    EXPECT_EQ(pictureOf(pixels, header, byWindow(50, 100)).bytes, (Bytes{0, 0, 128, 255, 255, 0, 255, 0}));
    header.isLowBright = true;
    EXPECT_EQ(pictureOf(pixels, header, byWindow(50, 100)).bytes, (Bytes{255, 255, 127, 0, 0, 0, 0, 255}));
    PlanarDisplay inverted = byWindow(50, 100);
    inverted.isInverted = true;
    EXPECT_EQ(pictureOf(pixels, header, inverted).bytes, (Bytes{0, 0, 128, 255, 255, 0, 255, 0}));
}

TEST(PlanarDisplays, ATableMapsWholeValuesAndKeepsToItsEnds) {
    const dicom::PlanarHeader header = withTable({0, 2048, 4095}, 12, -1);
    PlanarDisplay display;
    display.table = 0;
    EXPECT_EQ(
        pictureOf(greyOf({-5, -1, 0, 0.4F, 1, 7, 1e30F, -1e30F, kNan, kInfinity}), header, display).bytes,
        (Bytes{0, 0, 128, 128, 255, 255, 255, 0, 0, 0}));
    // Entries beyond the bits that the table says it has are white.
    EXPECT_EQ(pictureOf(greyOf({0}), withTable({4095}, 8), display).bytes, Bytes{255});
}

TEST(PlanarDisplays, AreTheFilesElseTheRangeOfValues) {
    dicom::Frame frame;
    const dicom::PlanarFrame pixels = greyOf({10, 20, 30, kNan});
    const PlanarDisplay range = usualDisplay(frame, {}, pixels);
    EXPECT_FALSE(range.table);
    EXPECT_GE(range.window.center, 10.0);
    EXPECT_LE(range.window.center, 30.0);
    frame.windows = {{.center = 40, .width = 400, .explanation = "SOFT", .function = {}}};
    EXPECT_EQ(usualDisplay(frame, {}, pixels).window, frame.windows[0]);
    EXPECT_EQ(usualDisplay(frame, withTable({1}, 8), pixels).table, 0u);
    frame.realWorld = true;  // whose values the window is not for
    EXPECT_NE(usualDisplay(frame, {}, pixels).window, frame.windows[0]);
}

TEST(PlanarDisplays, OfNothingAreFinite) {
    for (const auto& values :
         {std::vector<float>{}, std::vector<float>{kNan, kInfinity}, std::vector<float>{7}}) {
        const dicom::PlanarFrame pixels = greyOf(values);
        const DisplayWindow window = wholeRange(pixels);
        EXPECT_TRUE(std::isfinite(window.center) && window.width > 0.0);
        EXPECT_EQ(pictureOf(pixels, {}, usualDisplay({}, {}, pixels)).bytes.size(), values.size());
    }
}

TEST(PlanarDisplays, ColoursStayUnlessInverted) {
    const dicom::PlanarFrame pixels{.columns = 1, .rows = 1, .values = {}, .rgb = {1, 2, 255}};
    PlanarDisplay display = byWindow(0, 1);
    EXPECT_EQ(pictureOf(pixels, {}, display).bytes, (Bytes{1, 2, 255}));
    display.isInverted = true;
    EXPECT_EQ(pictureOf(pixels, {}, display).bytes, (Bytes{254, 253, 0}));
}

}  // namespace
}  // namespace macula::study
