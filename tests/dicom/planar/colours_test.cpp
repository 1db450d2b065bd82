// Colours against their definitions in double precision, and palettes well and badly made.
#include "dicom/planar/colours.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support.h"
#include "synthetic.h"

namespace macula::dicom::test {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

std::uint8_t rounded(double value) {
    return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

// ITU-T T.871, solved for red, green and blue from the luminances that define it.
Rgb ofYbrFull(double y, double cb, double cr) {
    constexpr double kRed = 0.299;
    constexpr double kBlue = 0.114;
    const double r = y + (cr - 128.0) * 2.0 * (1.0 - kRed);
    const double b = y + (cb - 128.0) * 2.0 * (1.0 - kBlue);
    const double g = (y - kRed * r - kBlue * b) / (1.0 - kRed - kBlue);
    return {rounded(r), rounded(g), rounded(b)};
}

TEST(Colours, OfYbrAreThoseOfTheirDefinition) {
    for (int y = 0; y <= 255; y += 5) {
        for (int cb = 0; cb <= 255; cb += 15) {
            for (int cr = 0; cr <= 255; cr += 15) {
                const std::array<std::uint16_t, 3> samples{std::uint16_t(y), std::uint16_t(cb),
                                                           std::uint16_t(cr)};
                const auto rgb = toRgb(ColourModel::ybrFull, 8, samples);
                const Rgb expected = ofYbrFull(y, cb, cr);
                for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(rgb[c], expected[c], 1) << y << cb << cr;
            }
        }
    }
}

TEST(Colours, OfPartialYbrSpanTheWholeRange) {
    const std::array<std::uint16_t, 9> samples{16, 128, 128, 235, 128, 128, 0, 128, 128};
    EXPECT_EQ(toRgb(ColourModel::ybrPartial, 8, samples),
              (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255, 0, 0, 0}));
}

TEST(Colours, OfAnyDepthEndInTheSameBytes) {
    for (const int bits : {1, 8, 12, 16}) {
        const auto most = std::uint16_t((1u << unsigned(bits)) - 1);
        const std::array<std::uint16_t, 3> samples{0, most, 0};
        EXPECT_EQ(toRgb(ColourModel::rgb, bits, samples), (std::vector<std::uint8_t>{0, 255, 0})) << bits;
    }
    const std::array<std::uint16_t, 3> beyond{65535, 65535, 65535};
    EXPECT_EQ(toRgb(ColourModel::rgb, 8, beyond), (std::vector<std::uint8_t>{255, 255, 255}));
    EXPECT_TRUE(toRgb(ColourModel::rgb, 8, {}).empty());
}

TEST(Colours, OnlyWhatTheStandardStillHasIsAModel) {
    EXPECT_EQ(colourModelOf("RGB"), ColourModel::rgb);
    EXPECT_EQ(colourModelOf("YBR_RCT"), ColourModel::rgb);
    EXPECT_EQ(colourModelOf("YBR_FULL_422"), ColourModel::ybrFull);
    for (const char* other : {"", "MONOCHROME2", "PALETTE COLOR", "HSV", "CMYK", "rgb"})
        EXPECT_FALSE(colourModelOf(other)) << other;
}

class PaletteTest : public testing::Test {
  protected:
    // Three tables of the same words, read from a file.
    std::optional<ColourPalette> read(std::array<std::uint16_t, 3> descriptor,
                                      const std::vector<Uint16>& words, bool isSegmented = false,
                                      bool isSigned = false) {
        SyntheticSeries series;
        series.edits.push_back([&](DcmItem& item) {
            for (const unsigned short c : {1, 2, 3}) {
                const auto table = static_cast<unsigned short>((isSegmented ? 0x1220 : 0x1200) + c);
                item.putAndInsertUint16Array(DcmTag(0x0028, static_cast<unsigned short>(0x1100 + c), EVR_US),
                                             descriptor.data(), 3);
                item.putAndInsertUint16Array(DcmTag(0x0028, table, EVR_OW), words.data(), words.size());
            }
        });
        const TemporaryFolder folder;
        const auto files = writeFiles(folder.path(), series, {slicesOf(series).front()});
        return readPalette(*readHeader(files.at(0)).header, isSigned);
    }
    static Rgb grey(int value) { return {std::uint8_t(value), std::uint8_t(value), std::uint8_t(value)}; }
};

TEST_F(PaletteTest, MapsFromItsFirstValueAndKeepsToItsEnds) {
    const auto palette = read({3, 10, 16}, {0x0100, 0x8000, 0xff00});
    ASSERT_TRUE(palette);
    EXPECT_EQ((*palette)(10), grey(1));
    EXPECT_EQ((*palette)(11), grey(0x80));
    EXPECT_EQ((*palette)(12), grey(0xff));
    EXPECT_EQ((*palette)(-5), grey(1));
    EXPECT_EQ((*palette)(4000), grey(0xff));
}

TEST_F(PaletteTest, OfSmallEntriesHasEightBitsWhateverItSays) {
    const auto palette = read({3, 0, 16}, {0, 128, 255});
    ASSERT_TRUE(palette);
    EXPECT_EQ((*palette)(1), grey(128));
}

TEST_F(PaletteTest, PacksTwoEntriesInAWord) {
    const auto palette = read({4, 0, 8}, {0x2010, 0x4030});
    ASSERT_TRUE(palette);
    for (int i = 0; i < 4; ++i) EXPECT_EQ((*palette)(i), grey(0x10 * (i + 1))) << i;
}

TEST_F(PaletteTest, BeginsBelowZeroForSignedPixels) {
    const auto palette = read({2, 0xffff, 16}, {0x1000, 0x2000}, false, true);
    ASSERT_TRUE(palette);
    EXPECT_EQ((*palette)(-1), grey(0x10));
    EXPECT_EQ((*palette)(0), grey(0x20));
}

TEST_F(PaletteTest, OfSegmentsIsExpanded) {
    // Two entries, a line of four to 0x6000, and the first segment once more.
    const auto palette = read({8, 0, 16}, {0, 2, 0x1000, 0x2000, 1, 4, 0x6000, 2, 1, 0, 0}, true);
    ASSERT_TRUE(palette);
    const std::array expected{0x10, 0x20, 0x30, 0x40, 0x50, 0x60, 0x10, 0x20};
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ((*palette)(int(i)), grey(expected[i])) << i;
}

TEST_F(PaletteTest, ThatDoesNotFitIsNone) {
    EXPECT_FALSE(read({4, 0, 16}, {0, 1, 2}));                                  // too short
    EXPECT_FALSE(read({3, 0, 12}, {0, 1, 2}));                                  // neither 8 nor 16 bits
    EXPECT_FALSE(read({4, 0, 16}, {1, 4, 7}, true));                            // a line from nowhere
    EXPECT_FALSE(read({4, 0, 16}, {0, 9, 7}, true));                            // a run beyond the end
    EXPECT_FALSE(read({4, 0, 16}, {2, 1, 0, 0}, true));                         // repeats itself
    EXPECT_FALSE(read({4, 0, 16}, {0, 1, 7, 2, 65535, 0xffff, 1}, true));       // from beyond the end
    EXPECT_FALSE(read({0, 0, 16}, {0, 1, 7, 1, 65535, 9, 1, 65535, 9}, true));  // more than a table has
}

}  // namespace
}  // namespace macula::dicom::test
