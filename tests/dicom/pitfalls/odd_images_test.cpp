// One image among many whose rescale, bits or position cannot be right: a gap, named by its number, and never
// a bright plate across the anatomy.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <fstream>
#include <limits>
#include <sstream>

#include "opened.h"

namespace macula::dicom::test {
namespace {

using OddRescale = Pitfall;
using OddPosition = Pitfall;
using OddBits = Pitfall;
using NonFinite = Pitfall;

constexpr int kOddNumber = 105;

// Slice 5 of 12 is edited and called 105; the others have the numbers 1 to 12.
std::vector<Slice> withOddSlice(SyntheticSeries& series, const Edit& edit) {
    series.shuffleNumbers = false;
    std::vector<Slice> slices = slicesOf(series);
    slices[5].instanceNumber = kOddNumber;
    if (edit) slices[5].edits.push_back(edit);
    return slices;
}

// The volume of the other slices, with that one in between them; the odd image is there for whoever asks.
void expectGapAtFive(const Opened& opened, const SyntheticSeries& series, std::string_view key) {
    EXPECT_EQ(opened.frames(), std::size_t(series.size.z));
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    expectVolumeOf(*volume, series);
    EXPECT_EQ(volume->provenance().interpolatedSlices, (std::vector<SliceRange>{{5, 5}}));
    const auto& ofLoading = volume->provenance().messages;
    const auto found = std::ranges::find(ofLoading, key, &Message::key);
    const Message* told = found != ofLoading.end() ? &*found : opened.find(key);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_EQ(told->severity, Severity::warning);
    EXPECT_NE(told->sentence.english().find(std::to_string(kOddNumber)), std::string::npos) << told->sentence;
    const auto& assumed = volume->provenance().assumptions;
    EXPECT_NE(std::ranges::find(assumed, told->sentence), assumed.end());
}

TEST_F(OddRescale, IsAGapAndNamed) {
    const std::pair<const char*, Edit> odd[]{
        {"no intercept", [](DcmItem& item) { erase(item, DCM_RescaleIntercept); }},
        {"no slope", [](DcmItem& item) { erase(item, DCM_RescaleSlope); }},
        {"neither",
         [](DcmItem& item) {
             erase(item, DCM_RescaleSlope);
             erase(item, DCM_RescaleIntercept);
         }},
        {"slope of 0", [](DcmItem& item) { put(item, DCM_RescaleSlope, "0"); }},
        {"slope that is no number", [](DcmItem& item) { put(item, DCM_RescaleSlope, "NaN"); }},
        {"intercept that is no number", [](DcmItem& item) { put(item, DCM_RescaleIntercept, "1e999"); }},
        {"negative slope", [](DcmItem& item) { put(item, DCM_RescaleSlope, "-1"); }},
        {"absurd intercept", [](DcmItem& item) { put(item, DCM_RescaleIntercept, "1e30"); }},
        {"absurd slope", [](DcmItem& item) { put(item, DCM_RescaleSlope, "1e20"); }},
        {"slope of nothing", [](DcmItem& item) { put(item, DCM_RescaleSlope, "1e-12"); }},
    };
    for (const char* modality : {"CT", "PT"}) {
        for (const auto& [name, edit] : odd) {
            SCOPED_TRACE(std::string(modality) + ", " + name);
            const TemporaryFolder own;
            SyntheticSeries s;
            s.modality = modality;
            const auto slices = withOddSlice(s, edit);
            writeFiles(own.path(), s, slices);
            expectGapAtFive(Opened(own.path()), s, key::kOddRescale);
        }
    }
}

// Where all others have 1 and 0, a missing rescale means the same.
TEST_F(OddRescale, MissingWhereOthersHaveOneAndZeroIsTheSame) {
    series.modality = "MR";
    series.intercept = 0.0;
    const auto slices = withOddSlice(series, [](DcmItem& item) {
        erase(item, DCM_RescaleSlope);
        erase(item, DCM_RescaleIntercept);
    });
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_TRUE(opened.says(key::kMissingRescale));
    EXPECT_FALSE(opened.says(key::kOddRescale));
}

// Half of the images without: neither half is mixed into the other.
TEST_F(OddRescale, HalfOfThemWithoutAreAStackOfTheirOwn) {
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        if (slice.place < 7) continue;
        slice.edits.push_back([](DcmItem& item) { erase(item, DCM_RescaleIntercept); });
    }
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 12u);
    ASSERT_EQ(opened.volumes().size(), 2u) << opened.keys();
    EXPECT_EQ(opened.volumes()[0]->frames.size(), 7u);
    EXPECT_TRUE(opened.says(key::kOddRescale));
}

// MR needs no rescale (PS3.3 A.4.3): magnitude without one and phase with one are two volumes, and no fault.
TEST_F(OddRescale, MagnitudeWithoutAndPhaseWith) {
    series.modality = "MR";
    series.phases = 2;
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.edits.push_back([phase = slice.phase](DcmItem& item) {
            put(item, DCM_ImageType, phase == 0 ? "ORIGINAL\\PRIMARY\\M\\ND" : "ORIGINAL\\PRIMARY\\P\\ND");
            if (phase != 0) return;
            erase(item, DCM_RescaleSlope);
            erase(item, DCM_RescaleIntercept);
        });
    }
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 24u);
    EXPECT_EQ(opened.volumes().size(), 2u) << opened.keys();
    EXPECT_FALSE(opened.says(key::kOddRescale)) << opened.keys();
    EXPECT_FALSE(opened.says(key::kMissingRescale)) << opened.keys();
    EXPECT_TRUE(opened.says(key::kSplitSeries)) << opened.keys();
}

// Slopes of PET differ from slice to slice, by far: that is no fault.
TEST_F(OddRescale, SlopesOfPetMayDifferByThousands) {
    series.modality = "PT";
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.intercept = 0.0;
        slice.slope = slice.place == 4 ? 500.0 : 0.1 * (1 + slice.place);
    }
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_FALSE(opened.says(key::kOddRescale)) << opened.keys();
    EXPECT_EQ(opened.volumes().size(), 1u);
}

TEST_F(OddPosition, IsAGapAndNamed) {
    const std::pair<const char*, Edit> odd[]{
        {"no number", [](DcmItem& item) { put(item, DCM_ImagePositionPatient, "nan\\0\\0"); }},
        {"infinite", [](DcmItem& item) { put(item, DCM_ImagePositionPatient, "0\\inf\\0"); }},
        {"missing", [](DcmItem& item) { erase(item, DCM_ImagePositionPatient); }},
        {"beyond all patients", [](DcmItem& item) { put(item, DCM_ImagePositionPatient, "0\\0\\1e30"); }},
        {"far along", [](DcmItem& item) { put(item, DCM_ImagePositionPatient, "100\\200\\90000"); }},
        {"far to the side", [](DcmItem& item) { put(item, DCM_ImagePositionPatient, "9000\\0\\0"); }},
    };
    for (const auto& [name, edit] : odd) {
        SCOPED_TRACE(name);
        const TemporaryFolder own;
        SyntheticSeries s;
        const auto slices = withOddSlice(s, edit);
        writeFiles(own.path(), s, slices);
        expectGapAtFive(Opened(own.path()), s, key::kOddPosition);
    }
}

// Whatever stackPlanes would refuse the whole stack for: more than a tenth of the distance of slices.
TEST_F(OddPosition, ShiftedBesideTheStack) {
    const std::vector<Slice> straight = withOddSlice(series, {});
    const double stepMm = glm::distance(straight[0].positionMm, straight[1].positionMm);
    for (const double mm : {0.15 * stepMm, 40.0}) {
        SCOPED_TRACE(mm);
        const TemporaryFolder own;
        auto slices = straight;
        slices[5].positionMm += mm * slices[5].rowDirection;
        writeFiles(own.path(), series, slices);
        expectGapAtFive(Opened(own.path()), series, key::kOddPosition);
    }
}

TEST_F(OddPosition, FarBeyondTheEndOfTheStack) {
    auto slices = withOddSlice(series, {});
    slices[5].positionMm = slices[11].positionMm + 10.0 * (slices[11].positionMm - slices[10].positionMm);
    writeFiles(folder.path(), series, slices);
    expectGapAtFive(open(), series, key::kOddPosition);
}

TEST_F(OddBits, PixelsThatCannotBeReadAreAGap) {
    auto slices = withOddSlice(series, [](DcmItem& item) { putWord(item, DCM_HighBit, 20); });
    writeFiles(folder.path(), series, slices);
    expectGapAtFive(open(), series, key::kOddEncoding);
}

TEST_F(OddBits, OnePrivateTransferSyntaxIsAGap) {
    const auto files = writeFiles(folder.path(), series, withOddSlice(series, {}));
    std::ostringstream text;
    text << std::ifstream(files[5], std::ios::binary).rdbuf();
    std::string bytes = text.str();
    const std::string known(UID_LittleEndianExplicitTransferSyntax);
    const std::string unknown = "1.2.3.4567.8.9.1.2.1";  // as long, with the padding
    const std::size_t at = bytes.find(known + '\0');
    ASSERT_NE(at, std::string::npos);
    std::ofstream(files[5], std::ios::binary) << bytes.replace(at, unknown.size(), unknown);
    expectGapAtFive(open(), series, key::kOddEncoding);
}

// The same patient's CT with a slice that says 8 bits, and whose values need more.
TEST_F(OddBits, FewerBitsThanTheValuesNeedIsAGap) {
    series.format = {16, 12, 11, false};
    const auto slices = withOddSlice(series, [](DcmItem& item) {
        putWord(item, DCM_BitsStored, 8);
        putWord(item, DCM_HighBit, 7);
    });
    writeFiles(folder.path(), series, slices);
    expectGapAtFive(open(), series, key::kBitsExceeded);
}

// All say 12; one has values beyond.
TEST_F(OddBits, ValuesBeyondTheBitsOfAllAreAGap) {
    series.format = {16, 12, 11, false};
    const auto slices = withOddSlice(series, [&](DcmItem& item) {
        const std::vector<Uint16> cells(std::size_t(series.size.x) * std::size_t(series.size.y), 5000);
        ASSERT_TRUE(item.putAndInsertUint16Array(DCM_PixelData, cells.data(), cells.size()).good());
    });
    writeFiles(folder.path(), series, slices);
    expectGapAtFive(open(), series, key::kBitsExceeded);
}

// Overlays in the bits above the stored ones are no values: said where nothing declares them.
TEST_F(OddBits, OverlaysInAllImagesAreDropped) {
    series.format = {16, 12, 11, false};
    series.cellNoise = 0x8000;
    for (const bool declared : {false, true}) {
        SCOPED_TRACE(declared);
        const TemporaryFolder own;
        SyntheticSeries s = series;
        if (declared) s.edits.push_back([](DcmItem& item) { putWord(item, DcmTagKey(0x6000, 0x0102), 15); });
        writeFiles(own.path(), s);
        const Opened opened(own.path());
        const auto volume = opened.onlyVolume();
        ASSERT_NE(volume, nullptr);
        expectVolumeOf(*volume, s);
        const auto& told = volume->provenance().messages;
        EXPECT_EQ(std::ranges::count(told, key::kBitsDropped, &Message::key), declared ? 0 : 1);
    }
}

TEST_F(NonFinite, FloatPixelsAreCountedAndPadding) {
    series.modality = "MR";
    series.size = {8, 7, 3};
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.edits.push_back([&](DcmItem& item) {
            std::vector<Float32> cells(56);
            for (int n = 0; n < 56; ++n) cells[std::size_t(n)] = 0.25f * float(n) + float(slice.place);
            if (slice.place == 1) {
                cells[3] = std::numeric_limits<float>::quiet_NaN();
                cells[4] = std::numeric_limits<float>::infinity();
                cells[5] = -std::numeric_limits<float>::infinity();
            }
            erase(item, DCM_PixelData);
            erase(item, DCM_RescaleSlope);
            erase(item, DCM_RescaleIntercept);
            putWord(item, DCM_BitsAllocated, 32);
            ASSERT_TRUE(item.putAndInsertFloat32Array(DCM_FloatPixelData, cells.data(), cells.size()).good());
        });
    }
    writeFiles(folder.path(), series, slices);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    for (const int i : {3, 4, 5}) EXPECT_TRUE(volume->isPadding(i, 0, 1)) << i;
    EXPECT_EQ(volume->value(2, 0, 1), 1.5);
    EXPECT_EQ(volume->valueRange()->high, 0.25 * 55 + 2.0);
    const auto& told = volume->provenance().messages;
    const auto at = std::ranges::find(told, key::kNonFiniteValues, &Message::key);
    ASSERT_NE(at, told.end());
    EXPECT_EQ(numberArgument(*at, "count"), 3.0);
}

}  // namespace
}  // namespace macula::dicom::test
