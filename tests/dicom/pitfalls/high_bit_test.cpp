// Where in a cell a value lies: HighBit that is wrong, in all images or in one. No value becomes a fraction
// of itself without a word.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "opened.h"

namespace macula::dicom::test {
namespace {

using HighBit = Pitfall;

const Message* messageOf(const Volume& volume, std::string_view key) {
    const auto& told = volume.provenance().messages;
    const auto found = std::ranges::find(told, key, &Message::key);
    return found == told.end() ? nullptr : &*found;
}

Edit saysHighBit(int bit) {
    return [bit](DcmItem& item) { putWord(item, DCM_HighBit, bit); };
}

struct Case {
    CellFormat format;  // of the cells
    int says;           // HighBit in the header
    const char* transferSyntaxUid;
};

TEST_F(HighBit, OfAllImagesThatValuesContradictIsNotBelieved) {
    const Case cases[]{
        {{16, 12, 11, false}, 15, "1.2.840.10008.1.2.1"}, {{16, 12, 11, true}, 15, "1.2.840.10008.1.2.1"},
        {{16, 12, 11, false}, 13, "1.2.840.10008.1.2.1"}, {{16, 8, 7, false}, 15, "1.2.840.10008.1.2.1"},
        {{16, 12, 11, false}, 15, "1.2.840.10008.1.2.5"}, {{16, 12, 11, false}, 15, "1.2.840.10008.1.2"},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(std::to_string(c.format.bitsStored) + " bits up to " + std::to_string(c.says) + " " +
                     c.transferSyntaxUid);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.size = {16, 14, 12};
        s.format = c.format;
        s.transferSyntaxUid = c.transferSyntaxUid;
        s.slope = c.format.bitsStored == 8 ? 1.0 : 4.0;
        s.intercept = c.format.bitsStored == 8 ? 0.0 : c.format.isSigned ? 1500.0 : -1000.0;
        if (c.format.bitsStored == 8)
            s.rawInstead = [](const Slice& slice, int i, int j) { return 7 * i + 5 * j + slice.place; };
        const auto slices = slicesOf(s);
        const auto files = writeFiles(own.path(), s, slices);
        for (const auto& file : files) editFile(file, saysHighBit(c.says));
        const auto volume = Opened(own.path()).onlyVolume();
        ASSERT_NE(volume, nullptr);
        const Message* told = messageOf(*volume, key::kBitsMisplaced);
        ASSERT_NE(told, nullptr);
        EXPECT_EQ(told->severity, Severity::warning);
        EXPECT_EQ(numberArgument(*told, "count"), 12.0);
        for (const Slice& slice : slices) {
            for (int i = 0; i < s.size.x; ++i)
                ASSERT_EQ(volume->value(i, 3, slice.place), rawAt(s, slice, i, 3) * s.slope + s.intercept);
        }
    }
}

// Signed values of less than the stored bits fill the whole cell with their sign.
TEST_F(HighBit, OfSignedValuesWhoseSignFillsTheCell) {
    series.size = {16, 14, 12};
    series.format = {16, 16, 15, true};
    series.slope = 4.0;
    series.intercept = 2000.0;
    const auto slices = slicesOf(series);
    for (const auto& file : writeFiles(folder.path(), series, slices)) {
        editFile(file, [](DcmItem& item) {
            putWord(item, DCM_BitsStored, 12);
            putWord(item, DCM_HighBit, 15);
        });
    }
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_NE(messageOf(*volume, key::kBitsMisplaced), nullptr);
    for (const Slice& slice : slices)
        EXPECT_EQ(volume->value(4, 3, slice.place), rawAt(series, slice, 4, 3) * 4.0 + 2000.0);
}

// One image of many: its neighbours say what it is, and it is a gap.
TEST_F(HighBit, OfOneImageIsAGap) {
    series.shuffleNumbers = false;
    series.format = {16, 12, 11, false};
    series.intercept = -24.0;
    const auto slices = slicesOf(series);
    const auto files = writeFiles(folder.path(), series, slices);
    editFile(files[5], saysHighBit(15));
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    expectVolumeOf(*volume, series);
    EXPECT_EQ(volume->provenance().interpolatedSlices, (std::vector<SliceRange>{{5, 5}}));
    const Message* told = messageOf(*volume, key::kBitsExceeded);
    ASSERT_NE(told, nullptr);
    EXPECT_NE(told->sentence.english().find('6'), std::string::npos) << told->sentence;
}

// Values that do lie at the high end, as the images say, with nothing or an overlay below.
TEST_F(HighBit, ThatIsRightIsBelieved) {
    for (const unsigned noise : {0u, 0x0004u, 0x000Fu}) {
        for (const bool declared : {false, true}) {
            SCOPED_TRACE(std::to_string(noise) + (declared ? " declared" : ""));
            const TemporaryFolder own;
            SyntheticSeries s;
            s.format = {16, 12, 15, false};
            s.intercept = -24.0;
            s.cellNoise = static_cast<std::uint16_t>(noise);
            if (declared) s.edits.push_back([](DcmItem& i) { putWord(i, DcmTagKey(0x6000, 0x0102), 2); });
            writeFiles(own.path(), s);
            const auto volume = Opened(own.path()).onlyVolume();
            ASSERT_NE(volume, nullptr);
            expectVolumeOf(*volume, s);
            EXPECT_EQ(messageOf(*volume, key::kBitsMisplaced), nullptr);
            const bool isToldOf = noise == 0x000Fu || (noise == 4u && !declared);
            EXPECT_EQ(messageOf(*volume, key::kBitsDropped) != nullptr, isToldOf);
        }
    }
}

// An overlay of one bit is no excuse for others.
TEST_F(HighBit, OfAnOverlayCountsForThatBitAlone) {
    series.format = {16, 12, 11, false};
    series.intercept = -24.0;
    series.cellNoise = 0x5000;
    series.edits.push_back([](DcmItem& item) { putWord(item, DcmTagKey(0x6000, 0x0102), 14); });
    writeFiles(folder.path(), series);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_NE(messageOf(*volume, key::kBitsDropped), nullptr);
}

// Fewer bits up to HighBit than are stored: nobody knows where the value lies.
TEST_F(HighBit, BelowTheStoredBitsIsNoFormat) {
    for (const auto& file : writeFiles(folder.path(), series)) editFile(file, saysHighBit(11));
    const Opened opened = open();
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_TRUE(opened.says(key::kUnsupportedBits)) << opened.keys();
}

}  // namespace
}  // namespace macula::dicom::test
