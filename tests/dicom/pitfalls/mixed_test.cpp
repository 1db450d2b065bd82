// D7 different things in one series, D8 one thing in several, D25 what is shown first.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "opened.h"

namespace macula::dicom::test {
namespace {

using D07MixedSeries = Pitfall;
using D08SpreadSeries = Pitfall;
using D25BestVolume = Pitfall;

// Another series of the writer that goes into the same DICOM series.
SyntheticSeries sibling(const SyntheticSeries& of, int number) {
    SyntheticSeries other = of;
    other.number = number;  // for the file names
    other.edits.push_back([n = of.number](DcmItem& item) { put(item, DCM_SeriesNumber, std::to_string(n)); });
    return other;
}

std::vector<Slice> withUids(std::vector<Slice> slices, const std::string& added, int numbersFrom) {
    for (Slice& slice : slices) {
        slice.sopInstanceUid += added;
        slice.instanceNumber += numbersFrom;
    }
    return slices;
}

// Both are volumes, each equal to what its half says.
void expectTwo(const Opened& opened, const SyntheticSeries& a, const SyntheticSeries& b) {
    EXPECT_EQ(opened.series().size(), 1u);
    const auto volumes = opened.volumes();
    ASSERT_EQ(volumes.size(), 2u) << opened.keys();
    EXPECT_EQ(opened.frames(), static_cast<std::size_t>(a.size.z + b.size.z));
    const auto isOf = [&](const Volume& volume, const SyntheticSeries& s) {
        return volume.size() == s.size && affineError(volume.worldFromVoxel(), s.expectedAffine()) < 1e-3 &&
               std::abs(volume.value(0, 0, 0) -
                        s.rampOf()(transformPoint(s.expectedAffine(), glm::dvec3(0)))) < 1.0;
    };
    const auto first = opened.load(*volumes[0]);
    const auto second = opened.load(*volumes[1]);
    ASSERT_TRUE(first && second);
    const bool swapped = !isOf(*first, a);
    expectVolumeOf(swapped ? *second : *first, a);
    expectVolumeOf(swapped ? *first : *second, b);
}

TEST_F(D07MixedSeries, LocalizerInFront) {
    SyntheticSeries scout = sibling(series, 2);
    scout.size = {16, 20, 1};
    scout.worldFromVoxel = affine({0, 1, 0}, {0, 0, -1}, {-1, 0, 0}, {0, -50, 100});
    scout.imageType = "ORIGINAL\\PRIMARY\\LOCALIZER";
    writeFiles(folder.path(), series);
    writeFiles(folder.path(), scout, withUids(slicesOf(scout), ".2", 100));
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_EQ(opened.frames(), 13u);
}

// The same matrix, spacing and orientation as the slices: only ImageType tells.
TEST_F(D07MixedSeries, LocalizerThatLooksLikeASlice) {
    auto slices = slicesOf(series);
    Slice scout = slices[5];
    scout.positionMm += scout.normal() * 0.7;
    scout.fileName = "scout";
    scout.sopInstanceUid += ".9";
    scout.instanceNumber = 0;
    scout.edits.push_back([](DcmItem& item) { put(item, DCM_ImageType, "ORIGINAL\\PRIMARY\\LOCALIZER"); });
    slices.push_back(scout);
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_EQ(opened.frames(), 13u);
}

TEST_F(D07MixedSeries, ThreeLocalizersAreNoVolume) {
    series.size.z = 3;
    series.imageType = "ORIGINAL\\PRIMARY\\LOCALIZER";
    writeFiles(folder.path(), series);
    const Opened opened = open();
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_TRUE(opened.says(key::kLocalizer)) << opened.keys();
    EXPECT_EQ(opened.frames(), 3u);
}

TEST_F(D07MixedSeries, TwoKernels) {
    SyntheticSeries sharp = sibling(series, 2);
    sharp.ramp = series.rampOf(1);
    const auto kernel = [](const char* name) {
        return [name](DcmItem& item) { put(item, DCM_ConvolutionKernel, name); };
    };
    series.edits.push_back(kernel("B31f"));
    sharp.edits.push_back(kernel("B70f"));
    writeFiles(folder.path(), series);
    writeFiles(folder.path(), sharp, withUids(slicesOf(sharp), ".2", 12));
    expectTwo(open(), series, sharp);
}

TEST_F(D07MixedSeries, TwoOrientations) {
    SyntheticSeries coronal = sibling(series, 2);
    coronal.worldFromVoxel =
        affine(series.worldFromVoxel[0], series.worldFromVoxel[2], series.worldFromVoxel[1], {1, 2, 3});
    writeFiles(folder.path(), series);
    writeFiles(folder.path(), coronal, withUids(slicesOf(coronal), ".2", 12));
    const Opened opened = open();
    expectTwo(opened, series, coronal);
    EXPECT_TRUE(opened.says(key::kInconsistentOrientation)) << opened.keys();
}

TEST_F(D07MixedSeries, TwoMatrixSizes) {
    SyntheticSeries other = sibling(series, 2);
    other.size = {10, 6, 4};
    writeFiles(folder.path(), series);
    writeFiles(folder.path(), other, withUids(slicesOf(other), ".2", 12));
    const Opened opened = open();
    expectTwo(opened, series, other);
    EXPECT_TRUE(opened.says(key::kInconsistentSize)) << opened.keys();
}

TEST_F(D07MixedSeries, TwoPixelSpacings) {
    SyntheticSeries zoomed = sibling(series, 2);
    for (int axis : {0, 1}) zoomed.worldFromVoxel[axis] *= 0.5;
    writeFiles(folder.path(), series);
    writeFiles(folder.path(), zoomed, withUids(slicesOf(zoomed), ".2", 12));
    const Opened opened = open();
    expectTwo(opened, series, zoomed);
    EXPECT_TRUE(opened.says(key::kInconsistentPixelSpacing)) << opened.keys();
}

// The patient moved between the two: their coordinates have nothing to do with each other.
TEST_F(D07MixedSeries, TwoFramesOfReference) {
    series.size.z = 6;
    SyntheticSeries moved = sibling(series, 2);
    moved.frameOfReferenceUid = "2.25.77";
    moved.worldFromVoxel[3] += series.worldFromVoxel[2] * 6.0;
    moved.ramp = series.rampOf(1);
    writeFiles(folder.path(), series);
    writeFiles(folder.path(), moved, withUids(slicesOf(moved), ".2", 12));
    const Opened opened = open();
    expectTwo(opened, series, moved);
    EXPECT_TRUE(opened.says(key::kInconsistentPosition)) << opened.keys();
}

// What varies along a whole volume does not split it.
TEST_F(D07MixedSeries, WhatVariesFromSliceToSliceDoesNotSplit) {
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.edits.push_back([n = slice.place](DcmItem& item) {
            put(item, DCM_XRayTubeCurrent, std::to_string(100 + 7 * n));
            put(item, DCM_ExposureTime, std::to_string(500 + n % 3));
            put(item, DCM_Exposure, std::to_string(90 + n));
            put(item, DCM_AcquisitionNumber, std::to_string(1 + n / 4));
            put(item, DCM_AcquisitionTime, fmt::format("1200{:02}", n));
            put(item, DCM_ContentTime, fmt::format("1210{:02}", n));
            put(item, DCM_TableHeight, std::to_string(120 + n % 2));
            put(item, DCM_WindowCenter, std::to_string(40 + n));
            put(item, DCM_SliceThickness, n % 2 ? "2.5" : "2.50001");
            put(item, DCM_ImageType,
                n % 2 ? "ORIGINAL\\PRIMARY\\AXIAL" : "ORIGINAL\\PRIMARY\\AXIAL\\CT_SOM5 SPI");
        });
    }
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_EQ(opened.stacks().size(), 1u);
}

// A dose report as a colour picture, at the end of a CT series.
TEST_F(D07MixedSeries, ColourPictureInTheSeries) {
    SyntheticSeries picture = sibling(series, 2);
    picture.size = {6, 5, 1};
    picture.sopClassUid = "1.2.840.10008.5.1.4.1.1.7";
    picture.imageType = "DERIVED\\SECONDARY";
    picture.edits.push_back([](DcmItem& item) {
        for (const DcmTagKey& tag : {DCM_ImagePositionPatient, DCM_ImageOrientationPatient, DCM_PixelSpacing,
                                     DCM_FrameOfReferenceUID, DCM_RescaleSlope, DCM_RescaleIntercept})
            erase(item, tag);
        put(item, DCM_PhotometricInterpretation, "RGB");
        putWord(item, DCM_SamplesPerPixel, 3);
        putWord(item, DCM_PlanarConfiguration, 0);
        putWord(item, DCM_BitsAllocated, 8);
        putWord(item, DCM_BitsStored, 8);
        putWord(item, DCM_HighBit, 7);
        const std::vector<Uint8> bytes(90, 200);
        item.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size());
    });
    writeFiles(folder.path(), series);
    writeFiles(folder.path(), picture, withUids(slicesOf(picture), ".2", 12));
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_EQ(opened.frames(), 13u);
    EXPECT_TRUE(opened.says(key::kColourImage)) << opened.keys();
}

TEST_F(D08SpreadSeries, TwoSeriesThatAbutArePointedOut) {
    SyntheticSeries next = series;
    next.seriesUid = "2.25.1009";
    next.number = 2;
    next.worldFromVoxel[3] += series.worldFromVoxel[2] * 12.0;
    writeFiles(folder.path(), series);
    writeFiles(folder.path(), next);
    const Opened opened = open();
    ASSERT_EQ(opened.series().size(), 2u);
    ASSERT_EQ(opened.volumes().size(), 2u);
    const Message* told = opened.find(key::kContinuesInOtherSeries);
    ASSERT_NE(told, nullptr) << opened.keys();
    expectVolumeOf(*opened.load(*opened.volumes()[0]), series);
    expectVolumeOf(*opened.load(*opened.volumes()[1]), next);
}

TEST_F(D08SpreadSeries, WhatOverlapsOrLiesApartDoesNotAbut) {
    for (const double steps : {5.0, 13.5, 40.0}) {
        SCOPED_TRACE(steps);
        const TemporaryFolder own;
        SyntheticSeries next = series;
        next.seriesUid = "2.25.1009";
        next.number = 2;
        next.worldFromVoxel[3] += series.worldFromVoxel[2] * steps;
        writeFiles(own.path(), series);
        writeFiles(own.path(), next);
        EXPECT_FALSE(Opened(own.path()).says(key::kContinuesInOtherSeries));
    }
}

SyntheticSeries numbered(int number, int slices, const char* imageType) {
    SyntheticSeries series;
    series.number = number;
    series.seriesUid = fmt::format("2.25.80{}", number);
    series.size.z = slices;
    series.imageType = imageType;
    series.ramp = Ramp{.value = 2000, .throughMm = glm::dvec3(series.worldFromVoxel[3]), .perMm = {1, 2, 3}};
    return series;
}

// Larger ones that are derived, and shorter ones, lose; and it is said why.
TEST_F(D25BestVolume, OriginalOfTwentySlicesComesFirst) {
    writeFiles(folder.path(), numbered(1, 3, "ORIGINAL\\PRIMARY\\LOCALIZER"));
    writeFiles(folder.path(), numbered(2, 60, "DERIVED\\SECONDARY\\MPR"));
    writeFiles(folder.path(), numbered(3, 21, "ORIGINAL\\PRIMARY\\AXIAL"));
    writeFiles(folder.path(), numbered(4, 24, "ORIGINAL\\PRIMARY\\AXIAL"));
    writeFiles(folder.path(), numbered(5, 19, "ORIGINAL\\PRIMARY\\AXIAL"));
    const Opened opened = open();
    const ChosenStack best = bestVolume(opened.scan());
    ASSERT_NE(best.stack, nullptr);
    ASSERT_NE(best.series, nullptr);
    EXPECT_EQ(best.series->number, 4);
    EXPECT_EQ(best.stack->frames.size(), 24u);
    EXPECT_FALSE(best.why.empty());
}

TEST_F(D25BestVolume, ADerivedVolumeIsBetterThanNone) {
    writeFiles(folder.path(), numbered(1, 3, "ORIGINAL\\PRIMARY\\LOCALIZER"));
    writeFiles(folder.path(), numbered(2, 5, "DERIVED\\SECONDARY\\MPR"));
    const Opened opened = open();
    const ChosenStack best = bestVolume(opened.scan());
    ASSERT_NE(best.series, nullptr);
    EXPECT_EQ(best.series->number, 2);
}

TEST_F(D25BestVolume, WhyThereIsNone) {
    writeFiles(folder.path(), numbered(1, 3, "ORIGINAL\\PRIMARY\\LOCALIZER"));
    const Opened opened = open();
    const ChosenStack best = bestVolume(opened.scan());
    EXPECT_EQ(best.stack, nullptr);
    EXPECT_FALSE(best.why.empty());
    EXPECT_EQ((best.why.english() + " ").find("SYNTHETIC"), std::string::npos);
}

}  // namespace
}  // namespace macula::dicom::test
