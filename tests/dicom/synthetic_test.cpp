// The writer of the tests: what it claims is what is in the file. What readers make of it is in pitfalls/.
#include "synthetic.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <set>

#include "support.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

std::vector<double> numbersAt(DcmItem& item, const DcmTagKey& tag) {
    std::vector<double> numbers;
    Float64 value = 0.0;
    for (unsigned long n = 0; item.findAndGetFloat64(tag, value, n, OFTrue).good(); ++n)
        numbers.push_back(value);
    return numbers;
}

// By hand: position (10, 20, 30), rows run to P, columns to S, so that the normal points to L.
TEST(Synthetic, APixelIsTheRampAtItsPlace) {
    const TemporaryFolder folder;
    SyntheticSeries series;
    series.size = {3, 2, 2};
    series.worldFromVoxel = affine({0, 0.5, 0}, {0, 0, 2}, {4, 0, 0}, {10, 20, 30});
    series.ramp = Ramp{.value = 100.0, .throughMm = {10, 20, 30}, .perMm = {1000, 10, 1}};
    series.slope = 0.5;
    series.intercept = -1.0;
    series.cellNoise = 0xF000;
    series.format = {16, 12, 11, false};
    series.ramp->perMm.x = 100;
    const auto files = writeFiles(folder.path(), series);
    ASSERT_EQ(files.size(), 2u);
    DcmFileFormat format;
    ASSERT_TRUE(format.loadFile(files[1].c_str()).good());
    DcmItem& item = *format.getDataset();
    EXPECT_EQ(numbersAt(item, DCM_ImagePositionPatient), (std::vector<double>{14, 20, 30}));
    EXPECT_EQ(numbersAt(item, DCM_ImageOrientationPatient), (std::vector<double>{0, 1, 0, 0, 0, 1}));
    EXPECT_EQ(numbersAt(item, DCM_PixelSpacing), (std::vector<double>{2, 0.5}));  // between rows first
    const Uint16* cells = nullptr;
    unsigned long count = 0;
    ASSERT_TRUE(item.findAndGetUint16Array(DCM_PixelData, cells, &count).good());
    ASSERT_EQ(count, 6u);
    // 100 + 4 mm * 100 = 500, each column 5 more, the second row 2 more; raw = (value + 1) / 0.5.
    EXPECT_EQ(std::vector<int>(cells, cells + 6),
              (std::vector<int>{0xF000 + 1002, 0xF000 + 1012, 0xF000 + 1022, 0xF000 + 1006, 0xF000 + 1016,
                                0xF000 + 1026}));
}

TEST(Synthetic, NamesAndNumbersSayNothingAndAreAllDifferent) {
    const SyntheticSeries series;
    const auto slices = slicesOf(series);
    std::set<std::string> names, uids;
    std::set<int> numbers;
    bool ascending = true;
    bool namesAscending = true;
    for (std::size_t n = 0; n < slices.size(); ++n) {
        names.insert(slices[n].fileName);
        uids.insert(slices[n].sopInstanceUid);
        numbers.insert(slices[n].instanceNumber);
        if (n == 0) continue;
        ascending = ascending && slices[n].instanceNumber > slices[n - 1].instanceNumber;
        namesAscending = namesAscending && slices[n].fileName > slices[n - 1].fileName;
    }
    EXPECT_EQ(names.size(), 12u);
    EXPECT_EQ(uids.size(), 12u);
    EXPECT_EQ(numbers.size(), 12u);
    EXPECT_EQ(*numbers.begin(), 1);
    EXPECT_EQ(*numbers.rbegin(), 12);
    EXPECT_FALSE(ascending);
    EXPECT_FALSE(namesAscending);
}

TEST(Synthetic, FunctionalGroupsHoldTheGeometryAndTheRootDoesNot) {
    const TemporaryFolder folder;
    SyntheticSeries series;
    series.modality = "MR";
    series.size = {3, 2, 4};
    series.phases = 2;
    const auto slices = slicesOf(series);
    writeMultiFrame(folder / "enhanced", series, slices);
    DcmFileFormat format;
    ASSERT_TRUE(format.loadFile((folder / "enhanced").c_str()).good());
    DcmItem& item = *format.getDataset();
    EXPECT_FALSE(item.tagExists(DCM_ImagePositionPatient));
    EXPECT_FALSE(item.tagExists(DCM_PixelSpacing));
    Sint32 frames = 0;
    EXPECT_TRUE(item.findAndGetSint32(DCM_NumberOfFrames, frames).good());
    EXPECT_EQ(frames, 8);
    DcmItem* last = nullptr;
    ASSERT_TRUE(item.findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, last, 7).good());
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(numbersAt(*last, DCM_ImagePositionPatient)[static_cast<std::size_t>(axis)],
                    slices[3].positionMm[axis], 1e-9);
    DcmItem* content = nullptr;
    ASSERT_TRUE(last->findAndGetSequenceItem(DCM_FrameContentSequence, content).good());
    Uint32 value = 0;
    ASSERT_TRUE(content->findAndGetUint32(DCM_DimensionIndexValues, value, 1).good());
    EXPECT_EQ(value, 4u);
    ASSERT_TRUE(content->findAndGetUint32(DCM_DimensionIndexValues, value, 2).good());
    EXPECT_EQ(value, 2u);
}

TEST(Synthetic, DecimalStringsFit) {
    EXPECT_EQ(decimal(0.1), "0.1");
    EXPECT_EQ(decimal(-1.0 / 3.0), "-0.3333333333333");
    EXPECT_EQ(decimal(1e-6), "1e-06");
    EXPECT_LE(decimal(-1.23456789012345e-101).size(), 16u);
}

}  // namespace
}  // namespace macula::dicom::test
