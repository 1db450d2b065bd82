// D11 padding, D12 photometric interpretation, D23 huge values (PS3.3 C.7.5.1.1.2, C.7.6.3.1.2).
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>

#include "opened.h"

namespace macula::dicom::test {
namespace {

using D11Padding = Pitfall;
using D12Photometric = Pitfall;
using D23HugeValues = Pitfall;

constexpr bool inCorner(int i, int j) {
    return i + j < 4;
}

TEST_F(D11Padding, SignedValueBeforeRescale) {
    series.format = {16, 16, 15, true};
    series.rawInstead = [](const Slice&, int i, int j) -> std::optional<int> {
        return inCorner(i, j) ? std::optional(-2000) : std::nullopt;
    };
    series.edits.push_back(
        [](DcmItem& item) { item.putAndInsertSint16(DcmTag(DCM_PixelPaddingValue, EVR_SS), -2000); });
    writeFiles(folder.path(), series);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    double least = 1e9;
    for (int k = 0; k < 12; ++k) {
        for (int j = 0; j < 7; ++j) {
            for (int i = 0; i < 8; ++i) {
                ASSERT_EQ(volume->isPadding(i, j, k), inCorner(i, j)) << i << " " << j << " " << k;
                if (!inCorner(i, j)) least = std::min(least, volume->value(i, j, k));
            }
        }
    }
    ASSERT_TRUE(volume->valueRange());
    EXPECT_EQ(volume->valueRange()->low, least);
    EXPECT_GT(least, 0.0);
}

TEST_F(D11Padding, RangeInEitherOrder) {
    for (const bool reversed : {false, true}) {
        SCOPED_TRACE(reversed);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.rawInstead = [](const Slice&, int i, int j) -> std::optional<int> {
            return inCorner(i, j) ? std::optional(3 + i + j) : std::nullopt;
        };
        s.edits.push_back([&](DcmItem& item) {
            putWord(item, DCM_PixelPaddingValue, reversed ? 6 : 3);
            putWord(item, DCM_PixelPaddingRangeLimit, reversed ? 3 : 6);
        });
        writeFiles(own.path(), s);
        const auto volume = Opened(own.path()).onlyVolume();
        ASSERT_NE(volume, nullptr);
        for (int j = 0; j < 7; ++j) {
            for (int i = 0; i < 8; ++i)
                EXPECT_EQ(volume->isPadding(i, j, 5), inCorner(i, j)) << i << " " << j;
        }
    }
}

// 63536 (-2000) cannot be in 12 bits: it is compared with whole cells. Masked it would be 2096, a value of
// the ramp: that is tissue, where a cell holds just it.
TEST_F(D11Padding, OutsideTheStoredBits) {
    series.format = {16, 12, 11, false};
    series.intercept = 0.0;
    series.edits.push_back([](DcmItem& item) {
        putWord(item, DCM_PixelPaddingValue, 63536);
        const Uint16* cells = nullptr;
        unsigned long count = 0;
        ASSERT_TRUE(item.findAndGetUint16Array(DCM_PixelData, cells, &count).good());
        std::vector<Uint16> changed(cells, cells + count);
        for (int j = 0; j < 7; ++j) {
            for (int i = 0; i < 8; ++i) {
                if (inCorner(i, j)) changed[static_cast<std::size_t>(8 * j + i)] = 63536;
                if (i == 7 && j == 0) changed[7] = 2096;
            }
        }
        ASSERT_TRUE(item.putAndInsertUint16Array(DCM_PixelData, changed.data(), count).good());
    });
    writeFiles(folder.path(), series);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    for (int k = 0; k < 12; ++k) {
        EXPECT_EQ(volume->value(7, 0, k), 2096.0);
        for (int j = 0; j < 7; ++j) {
            for (int i = 0; i < 8; ++i)
                ASSERT_EQ(volume->isPadding(i, j, k), inCorner(i, j)) << i << " " << j << " " << k;
        }
    }
}

TEST_F(D11Padding, WithSlopesThatDiffer) {
    series.modality = "PT";
    series.rawInstead = [](const Slice&, int i, int j) -> std::optional<int> {
        return inCorner(i, j) ? std::optional(7) : std::nullopt;
    };
    series.edits.push_back([](DcmItem& item) { putWord(item, DCM_PixelPaddingValue, 7); });
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.slope = 0.25 * (1 + slice.place);
        slice.intercept = 0.0;
    }
    writeFiles(folder.path(), series, slices);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    for (int k = 0; k < 12; ++k) {
        for (int j = 0; j < 7; ++j) {
            for (int i = 0; i < 8; ++i) {
                ASSERT_EQ(volume->isPadding(i, j, k), inCorner(i, j)) << i << " " << j << " " << k;
                if (inCorner(i, j)) continue;
                ASSERT_NEAR(volume->value(i, j, k),
                            series.rampOf()(transformPoint(series.worldFromVoxel, {i, j, k})),
                            0.126 * (1 + k));
            }
        }
    }
    ASSERT_TRUE(volume->valueRange());
    EXPECT_GT(volume->valueRange()->low, 1000.0);
}

TEST_F(D11Padding, AMissingSliceBetweenPaddingIsPadding) {
    series.rawInstead = [](const Slice&, int i, int j) -> std::optional<int> {
        return inCorner(i, j) ? std::optional(0) : std::nullopt;
    };
    series.edits.push_back([](DcmItem& item) { putWord(item, DCM_PixelPaddingValue, 0); });
    auto slices = slicesOf(series);
    slices.erase(slices.begin() + 5);
    writeFiles(folder.path(), series, slices);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    ASSERT_EQ(volume->size().z, 12);
    for (int j = 0; j < 7; ++j) {
        for (int i = 0; i < 8; ++i) EXPECT_EQ(volume->isPadding(i, j, 5), inCorner(i, j)) << i << " " << j;
    }
}

TEST_F(D12Photometric, MonochromeOneKeepsItsValues) {
    series.edits.push_back([](DcmItem& item) { put(item, DCM_PhotometricInterpretation, "MONOCHROME1"); });
    writeFiles(folder.path(), series);
    const Opened opened = open();
    EXPECT_TRUE(opened.says(key::kInvertedDisplay)) << opened.keys();
    expectOnlyVolume(opened, series);
}

TEST_F(D12Photometric, ColourIsNoVolume) {
    for (const char* photometric : {"RGB", "YBR_FULL", "YBR_FULL_422", "PALETTE COLOR"}) {
        SCOPED_TRACE(photometric);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.size = {4, 4, 3};
        s.format = {8, 8, 7, false};
        s.rawInstead = [](const Slice&, int i, int j) { return i + j; };
        s.edits.push_back([&](DcmItem& item) {
            put(item, DCM_PhotometricInterpretation, photometric);
            if (std::string(photometric) == "PALETTE COLOR") return;
            putWord(item, DCM_SamplesPerPixel, 3);
            putWord(item, DCM_PlanarConfiguration, 0);
            const std::vector<Uint8> bytes(48, 100);
            item.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size());
        });
        writeFiles(own.path(), s);
        const Opened opened(own.path());
        EXPECT_TRUE(opened.volumes().empty());
        EXPECT_EQ(opened.frames(), 3u);
        EXPECT_TRUE(opened.says(key::kColourImage)) << opened.keys();
    }
}

// Metal on the extended CT scale: no value is clipped.
TEST_F(D23HugeValues, AllSixteenBits) {
    series.rawInstead = [](const Slice& slice, int i, int j) {
        if (i == 0 && j == 0) return 0;
        if (i == 7 && j == 6) return 65535;
        return 30000 + slice.place;
    };
    series.intercept = -1024.0;
    writeFiles(folder.path(), series);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->value(0, 0, 3), -1024.0);
    EXPECT_EQ(volume->value(7, 6, 3), 64511.0);
    EXPECT_EQ(volume->value(3, 3, 3), 28979.0);
    ASSERT_TRUE(volume->valueRange());
    EXPECT_EQ(*volume->valueRange(), (ValueRange{-1024.0, 64511.0}));
}

TEST_F(D23HugeValues, ExtendedScaleOfTen) {
    series.slope = 10.0;
    series.intercept = -10240.0;
    series.rawInstead = [](const Slice&, int i, int j) { return 4000 - 100 * i - j; };
    writeFiles(folder.path(), series);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->value(0, 0, 0), 29760.0);
    EXPECT_EQ(volume->value(7, 6, 11), 10.0 * (4000 - 706) - 10240.0);
}

}  // namespace
}  // namespace macula::dicom::test
