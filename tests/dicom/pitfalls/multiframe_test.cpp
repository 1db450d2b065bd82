// D13 enhanced multi-frame objects (PS3.3 C.7.6.16), D14 secondary captures, D8 concatenations.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <random>

#include "opened.h"

namespace macula::dicom::test {
namespace {

class D13MultiFrame : public Pitfall {
  protected:
    D13MultiFrame() { series.modality = "MR"; }

    std::vector<Slice> shuffled() const {
        auto slices = slicesOf(series);
        std::shuffle(slices.begin(), slices.end(), std::mt19937(7));
        return slices;
    }
};
using D14SecondaryCapture = Pitfall;
using D08Concatenation = Pitfall;

TEST_F(D13MultiFrame, SharedOrPerFrameAnyOrder) {
    for (const char* modality : {"CT", "MR", "PT"}) {
        for (int where = 0; where < 8; ++where) {
            SCOPED_TRACE(fmt::format("{} {}", modality, where));
            const TemporaryFolder own;
            series.modality = modality;
            writeMultiFrame(own / "enhanced", series, shuffled(),
                            {.sharedMeasures = (where & 1) != 0,
                             .sharedOrientation = (where & 2) != 0,
                             .sharedTransformation = (where & 4) != 0});
            const Opened opened(own.path());
            expectOnlyVolume(opened, series);
            EXPECT_EQ(opened.frames(), 12u);
        }
    }
}

// The top level has geometry too, left over from a conversion: the functional groups are the truth.
TEST_F(D13MultiFrame, FunctionalGroupsOverTopLevel) {
    writeMultiFrame(folder / "enhanced", series, shuffled(),
                    {.edits = {[](DcmItem& item) {
                         put(item, DCM_ImagePositionPatient, "1\\2\\3");
                         put(item, DCM_ImageOrientationPatient, "1\\0\\0\\0\\1\\0");
                         put(item, DCM_PixelSpacing, "9\\9");
                         put(item, DCM_RescaleSlope, "5");
                         put(item, DCM_RescaleIntercept, "5");
                     }}});
    expectOnlyVolume(open(), series);
}

TEST_F(D13MultiFrame, PerFrameOverShared) {
    auto slices = shuffled();
    writeMultiFrame(folder / "enhanced", series, slices,
                    {.sharedMeasures = false,
                     .sharedOrientation = false,
                     .sharedTransformation = false,
                     .edits = {[](DcmItem& item) {
                         DcmItem& shared = nested(item, DCM_SharedFunctionalGroupsSequence);
                         put(nested(shared, DCM_PixelMeasuresSequence), DCM_PixelSpacing, "9\\9");
                         put(nested(shared, DCM_PlaneOrientationSequence), DCM_ImageOrientationPatient,
                             "1\\0\\0\\0\\1\\0");
                         put(nested(shared, DCM_PixelValueTransformationSequence), DCM_RescaleSlope, "3");
                     }}});
    expectOnlyVolume(open(), series);
}

TEST_F(D13MultiFrame, SlopePerFrame) {
    auto slices = shuffled();
    for (Slice& slice : slices) {
        slice.slope = 0.5 + 0.125 * slice.place;
        slice.intercept = -100.0 * slice.place;
    }
    writeMultiFrame(folder / "enhanced", series, slices, {.sharedTransformation = false});
    const Opened opened = open();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    expectGrid(*volume, series.size, series.expectedAffine());
    expectRamp(*volume, series.rampOf(), 1.0);
    for (const Slice& slice : slices) {
        const double exact = rawAt(series, slice, 4, 3) * slice.slope + slice.intercept;
        EXPECT_NEAR(volume->value(4, 3, slice.place), exact, 1e-6 * std::abs(exact));
    }
}

TEST_F(D13MultiFrame, TemporalPositions) {
    series.phases = 3;
    writeMultiFrame(folder / "enhanced", series, shuffled());
    expectPhases(open(), series);
}

TEST_F(D13MultiFrame, EffectiveEchoTimes) {
    series.phases = 2;
    auto slices = shuffled();
    for (Slice& slice : slices) {
        slice.edits.push_back([phase = slice.phase](DcmItem& groups) {
            putNumber(nested(groups, DCM_MREchoSequence), DCM_EffectiveEchoTime, 5.0 + 5.0 * phase);
        });
    }
    writeMultiFrame(folder / "enhanced", series, slices, {.dimensions = false});
    expectPhases(open(), series);
}

TEST_F(D13MultiFrame, BValues) {
    series.phases = 2;
    auto slices = shuffled();
    for (Slice& slice : slices) {
        slice.edits.push_back([phase = slice.phase](DcmItem& groups) {
            putNumber(nested(groups, DCM_MRDiffusionSequence), DCM_DiffusionBValue, 1000.0 * phase);
        });
    }
    writeMultiFrame(folder / "enhanced", series, slices, {.dimensions = false});
    expectPhases(open(), series);
}

TEST_F(D13MultiFrame, FrameTypes) {
    series.phases = 2;
    auto slices = shuffled();
    for (Slice& slice : slices) {
        slice.edits.push_back([phase = slice.phase](DcmItem& groups) {
            put(nested(groups, DCM_MRImageFrameTypeSequence), DCM_FrameType,
                phase ? "ORIGINAL\\PRIMARY\\DIXON\\WATER" : "DERIVED\\PRIMARY\\DIXON\\FAT");
        });
    }
    writeMultiFrame(folder / "enhanced", series, slices,
                    {.dimensions = false, .edits = {[](DcmItem& item) {
                                              put(item, DCM_ImageType, "MIXED\\PRIMARY\\DIXON\\MIXED");
                                          }}});
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 24u);
    ASSERT_EQ(opened.volumes().size(), 2u) << opened.keys();
}

// Two frames at every place, and nothing says which belong together.
TEST_F(D13MultiFrame, DuplicatePositionsAreAQuestion) {
    series.phases = 2;
    writeMultiFrame(folder / "enhanced", series, shuffled(), {.dimensions = false});
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 24u);
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_TRUE(opened.says(key::kDuplicatePositions)) << opened.keys();
}

TEST_F(D13MultiFrame, CardiacPhases) {
    series.phases = 3;
    auto slices = shuffled();
    for (Slice& slice : slices) {
        slice.edits.push_back([phase = slice.phase](DcmItem& groups) {
            putNumber(nested(groups, DCM_CardiacSynchronizationSequence), DCM_NominalPercentageOfCardiacPhase,
                      5.0 + 30.0 * phase);
        });
    }
    writeMultiFrame(folder / "enhanced", series, slices, {.dimensions = false});
    expectPhases(open(), series);
}

// Two reconstructions with another zoom in one object.
TEST_F(D13MultiFrame, PixelMeasuresThatDiffer) {
    series.ramp = series.rampOf();
    SyntheticSeries zoomed = series;
    for (const int axis : {0, 1}) zoomed.worldFromVoxel[axis] *= 0.5;
    auto slices = slicesOf(series);
    for (const Slice& slice : slicesOf(zoomed)) slices.push_back(slice);
    std::shuffle(slices.begin(), slices.end(), std::mt19937(9));
    writeMultiFrame(folder / "enhanced", series, slices, {.sharedMeasures = false});
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 24u);
    ASSERT_EQ(opened.volumes().size(), 2u) << opened.keys();
    for (const Stack* stack : opened.volumes()) {
        const auto volume = opened.load(*stack);
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->size().z, 12);
        expectRamp(*volume, *series.ramp);
    }
}

// One object with an axial and a coronal stack.
TEST_F(D13MultiFrame, Stacks) {
    SyntheticSeries coronal = series;
    coronal.worldFromVoxel =
        affine(series.worldFromVoxel[0], series.worldFromVoxel[2], series.worldFromVoxel[1], {1, 2, 3});
    coronal.ramp = series.rampOf();
    series.ramp = series.rampOf();
    auto slices = slicesOf(series);
    for (Slice slice : slicesOf(coronal)) {
        slice.stackId = "2";
        slices.push_back(slice);
    }
    std::shuffle(slices.begin(), slices.end(), std::mt19937(8));
    writeMultiFrame(folder / "enhanced", series, slices,
                    {.sharedMeasures = false, .sharedOrientation = false});
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 24u);
    const auto volumes = opened.volumes();
    ASSERT_EQ(volumes.size(), 2u) << opened.keys();
    for (const Stack* stack : volumes) {
        const auto volume = opened.load(*stack);
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->size(), glm::ivec3(8, 7, 12));
        expectRamp(*volume, series.rampOf());
    }
}

// Stacks that make one even volume end to end are one, and said; with a gap between them they are two.
TEST_F(D13MultiFrame, StacksEndToEndAreOne) {
    for (const bool apart : {false, true}) {
        const TemporaryFolder own;
        auto slices = slicesOf(series);
        for (Slice& slice : slices) {
            slice.stackId = slice.place < 6 ? "A" : "B";
            if (apart && slice.place >= 6) slice.positionMm += 0.4 * glm::dvec3(series.worldFromVoxel[2]);
        }
        writeMultiFrame(own / "enhanced", series, slices);
        const Opened opened(own.path());
        EXPECT_EQ(opened.frames(), 12u);
        EXPECT_EQ(opened.says(key::kStacksJoined), !apart);
        ASSERT_EQ(opened.volumes().size(), apart ? 2u : 1u) << opened.keys();
        for (const Stack* stack : opened.volumes()) {
            const auto volume = opened.load(*stack);
            ASSERT_NE(volume, nullptr);
            EXPECT_EQ(volume->size().z, apart ? 6 : 12);
            if (!apart) expectVolumeOf(*volume, series);
        }
    }
}

TEST_F(D13MultiFrame, LegacyConverted) {
    series.modality = "CT";
    series.sopClassUid = "1.2.840.10008.5.1.4.1.1.2.2";
    auto slices = shuffled();
    for (Slice& slice : slices) {
        slice.edits.push_back([n = slice.instanceNumber](DcmItem& groups) {
            put(nested(groups, DCM_UnassignedPerFrameConvertedAttributesSequence), DCM_InstanceNumber,
                std::to_string(n));
        });
    }
    writeMultiFrame(folder / "legacy", series, slices, {.dimensions = false});
    expectOnlyVolume(open(), series);
}

TEST_F(D13MultiFrame, RunLengthEncoded) {
    series.transferSyntaxUid = "1.2.840.10008.1.2.5";
    writeMultiFrame(folder / "enhanced", series, shuffled());
    expectOnlyVolume(open(), series);
}

TEST_F(D13MultiFrame, BigEndianAndDeflated) {
    for (const char* syntax : {"1.2.840.10008.1.2.2", "1.2.840.10008.1.2.1.99", "1.2.840.10008.1.2"}) {
        SCOPED_TRACE(syntax);
        const TemporaryFolder own;
        series.transferSyntaxUid = syntax;
        writeMultiFrame(own / "enhanced", series, shuffled());
        expectOnlyVolume(Opened(own.path()), series);
    }
}

TEST_F(D13MultiFrame, WhatIsMissingIsNamed) {
    struct Case {
        std::string_view key;
        Edit spoil;
    };
    const Case cases[] = {
        {key::kMultiFrameNoPixelMeasures,
         [](DcmItem& item) {
             erase(nested(item, DCM_SharedFunctionalGroupsSequence), DCM_PixelMeasuresSequence);
         }},
        {key::kMultiFrameNoOrientation,
         [](DcmItem& item) {
             erase(nested(item, DCM_SharedFunctionalGroupsSequence), DCM_PlaneOrientationSequence);
         }},
        {key::kMultiFrameNoPosition,
         [](DcmItem& item) { erase(item, DCM_PerFrameFunctionalGroupsSequence); }},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.key);
        const TemporaryFolder own;
        writeMultiFrame(own / "enhanced", series, shuffled(), {.edits = {c.spoil}});
        const Opened opened(own.path());
        EXPECT_TRUE(opened.volumes().empty());
        EXPECT_EQ(opened.frames(), 12u);
        EXPECT_TRUE(opened.says(c.key)) << opened.keys();
    }
}

// The file says 12 frames and describes 8: the other four have no place.
TEST_F(D13MultiFrame, FewerDescriptionsThanFrames) {
    series.phases = 1;
    auto slices = slicesOf(series);
    writeMultiFrame(folder / "enhanced", series, slices,
                    {.edits = {[](DcmItem& item) {
                         DcmSequenceOfItems* groups = nullptr;
                         item.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, groups);
                         ASSERT_NE(groups, nullptr);
                         for (int n = 0; n < 4; ++n) delete groups->remove(groups->card() - 1);
                     }}});
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 12u);
    EXPECT_FALSE(opened.keys().empty());
    for (const Stack* stack : opened.volumes()) {
        const auto volume = opened.load(*stack);
        ASSERT_NE(volume, nullptr);
        EXPECT_LE(volume->size().z, 8);
        expectRamp(*volume, series.rampOf());
    }
}

// NumberOfFrames is more than the pixel data hold: the rest is a loss, and is told.
TEST_F(D13MultiFrame, MoreFramesClaimedThanThere) {
    writeMultiFrame(folder / "enhanced", series, slicesOf(series));
    std::filesystem::resize_file(folder / "enhanced",
                                 std::filesystem::file_size(folder / "enhanced") - 2 * 8 * 7 * 2 - 10);
    const Opened opened = open();
    const Message* told = opened.find(key::kMissingFrames);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_EQ(numberArgument(*told, "missing"), 3.0);
    EXPECT_EQ(numberArgument(*told, "total"), 12.0);
    const auto volumes = opened.volumes();
    ASSERT_EQ(volumes.size(), 1u) << opened.keys();
    const auto volume = opened.load(*volumes[0]);
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->size().z, 9);
    expectRamp(*volume, series.rampOf());
}

TEST_F(D13MultiFrame, TenThousandFrames) {
    series.size = {2, 2, 10000};
    series.worldFromVoxel = affine({1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}, {0, 0, -500});
    series.ramp = Ramp{.value = 30000, .throughMm = {0, 0, 0}, .perMm = {100, 300, 50}};
    writeMultiFrame(folder / "enhanced", series, shuffled(), {.dimensions = false});
    expectOnlyVolume(open(), series);
}

// Frames of a nuclear medicine reconstruction: one place and direction, and a spacing whose sign says where
// the slices go (PS3.3 C.8.4.14).
TEST_F(D13MultiFrame, NuclearMedicineDetectors) {
    for (const double sign : {1.0, -1.0}) {
        SCOPED_TRACE(sign);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.modality = "NM";
        s.sopClassUid = "1.2.840.10008.5.1.4.1.1.20";
        s.size = {6, 5, 9};
        s.writeRescale = false;
        s.intercept = 0.0;
        s.imageType = "ORIGINAL\\PRIMARY\\RECON TOMO\\EMISSION";
        s.worldFromVoxel = affine({4, 0, 0}, {0, 4.5, 0}, {0, 0, 5 * sign}, {-10, -20, -30});
        s.ramp = Ramp{.throughMm = {0, 0, 0}, .perMm = {11, 23, 17}};
        writeMultiFrame(own / "nm", s, slicesOf(s),
                        {.functionalGroups = false,
                         .dimensions = false,
                         .edits = {[&](DcmItem& item) {
                             put(item, DCM_PixelSpacing, "4.5\\4");
                             put(item, DCM_SpacingBetweenSlices, decimal(5 * sign));
                             put(item, DCM_SliceThickness, "5");
                             putWord(item, DCM_NumberOfSlices, 9);
                             item.putAndInsertTagKey(DCM_FrameIncrementPointer, DCM_SliceVector);
                             const std::vector<Uint16> vector{1, 2, 3, 4, 5, 6, 7, 8, 9};
                             item.putAndInsertUint16Array(DCM_SliceVector, vector.data(), 9);
                             DcmItem& detector = nested(item, DCM_DetectorInformationSequence);
                             put(detector, DCM_ImagePositionPatient, "-10\\-20\\-30");
                             put(detector, DCM_ImageOrientationPatient, "1\\0\\0\\0\\1\\0");
                         }}});
        expectOnlyVolume(Opened(own.path()), s);
    }
}

// SliceVector says which slice a frame is: here the last comes first.
TEST_F(D13MultiFrame, NuclearMedicineInReverse) {
    series.modality = "NM";
    series.sopClassUid = "1.2.840.10008.5.1.4.1.1.20";
    series.size = {6, 5, 9};
    series.writeRescale = false;
    series.intercept = 0.0;
    series.imageType = "ORIGINAL\\PRIMARY\\RECON TOMO\\EMISSION";
    series.worldFromVoxel = affine({4, 0, 0}, {0, 4.5, 0}, {0, 0, 5}, {-10, -20, -30});
    series.ramp = Ramp{.throughMm = {0, 0, 0}, .perMm = {11, 23, 17}};
    auto slices = slicesOf(series);
    std::reverse(slices.begin(), slices.end());
    writeMultiFrame(folder / "nm", series, slices,
                    {.functionalGroups = false,
                     .dimensions = false,
                     .edits = {[](DcmItem& item) {
                         put(item, DCM_PixelSpacing, "4.5\\4");
                         put(item, DCM_SpacingBetweenSlices, "5");
                         putWord(item, DCM_NumberOfSlices, 9);
                         item.putAndInsertTagKey(DCM_FrameIncrementPointer, DCM_SliceVector);
                         const std::vector<Uint16> vector{9, 8, 7, 6, 5, 4, 3, 2, 1};
                         item.putAndInsertUint16Array(DCM_SliceVector, vector.data(), 9);
                         DcmItem& detector = nested(item, DCM_DetectorInformationSequence);
                         put(detector, DCM_ImagePositionPatient, "-10\\-20\\-30");
                         put(detector, DCM_ImageOrientationPatient, "1\\0\\0\\0\\1\\0");
                     }}});
    expectOnlyVolume(open(), series);
}

// One position, one orientation and one distance for all frames, as some cone-beam scanners write volumes.
TEST_F(D13MultiFrame, FramesThatFollowTheFirstAreAVolumeAndItIsSaid) {
    series.modality = "CT";
    series.sopClassUid = UID_CTImageStorage;
    series.worldFromVoxel = glm::dmat4(1.0);
    series.worldFromVoxel[0] = {0.7, 0, 0, 0};
    series.worldFromVoxel[1] = {0, 0.9, 0, 0};
    series.worldFromVoxel[2] = {0, 0, 2, 0};
    series.worldFromVoxel[3] = {-10, -20, -30, 1};
    series.writeRescale = false;
    const Edit geometry = [this](DcmItem& item) {
        put(item, DCM_ImagePositionPatient, "-10\\-20\\-30");
        put(item, DCM_ImageOrientationPatient, "1\\0\\0\\0\\1\\0");
        put(item, DCM_PixelSpacing, "0.9\\0.7");
        put(item, DCM_SpacingBetweenSlices, "2");
        put(item, DCM_RescaleSlope, decimal(series.slope));
        put(item, DCM_RescaleIntercept, decimal(series.intercept));
    };
    const MultiFrame flat{.functionalGroups = false, .dimensions = false, .edits = {geometry}};
    writeMultiFrame(folder / "volume", series, slicesOf(series), flat);
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    const Message* told = opened.find(key::kFramesInARow);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_EQ(told->severity, Severity::warning);

    // Frames of a film are at one place.
    for (const DcmTagKey& tag : {DCM_FrameTime, DCM_CineRate}) {
        const TemporaryFolder own;
        MultiFrame film = flat;
        film.edits.push_back([&](DcmItem& item) { put(item, tag, "40"); });
        writeMultiFrame(own / "film", series, slicesOf(series), film);
        const Opened filmed(own.path());
        EXPECT_TRUE(filmed.volumes().empty());
        EXPECT_FALSE(filmed.says(key::kFramesInARow));
    }
}

// Ultrasound: positions and orientation in the frame of the volume.
TEST_F(D13MultiFrame, UltrasoundLiesInAFrameOfItsOwn) {
    series.modality = "US";
    series.sopClassUid = UID_EnhancedUSVolumeStorage;
    series.imageType = "ORIGINAL\\PRIMARY\\VOLUME\\NONE";
    series.intercept = 0.0;
    const auto moved = [](DcmItem& groups, const DcmTagKey& from, const DcmTagKey& source,
                          const DcmTagKey& to, const DcmTagKey& target, unsigned long count) {
        DcmItem* macro = nullptr;
        if (groups.findAndGetSequenceItem(from, macro).bad()) return;
        std::vector<Float64> values;
        for (unsigned long i = 0; i < count; ++i) {
            Float64 value = 0.0;
            ASSERT_TRUE(macro->findAndGetFloat64(source, value, i).good());
            values.push_back(value);
        }
        ASSERT_TRUE(nested(groups, to).putAndInsertFloat64Array(target, values.data(), count).good());
        erase(groups, from);
    };
    const Edit toVolume = [&](DcmItem& item) {
        put(item, DCM_VolumeFrameOfReferenceUID, "2.25.1777");
        moved(nested(item, DCM_SharedFunctionalGroupsSequence), DCM_PlaneOrientationSequence,
              DCM_ImageOrientationPatient, DCM_PlaneOrientationVolumeSequence, DCM_ImageOrientationVolume, 6);
        DcmSequenceOfItems* frames = nullptr;
        ASSERT_TRUE(item.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, frames).good());
        for (unsigned long f = 0; f < frames->card(); ++f)
            moved(*frames->getItem(f), DCM_PlanePositionSequence, DCM_ImagePositionPatient,
                  DCM_PlanePositionVolumeSequence, DCM_ImagePositionVolume, 3);
    };
    writeMultiFrame(folder / "us", series, shuffled(), {.edits = {toVolume}});
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    const Message* told = opened.find(key::kSidesUnknown);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_EQ(told->severity, Severity::warning);
    ASSERT_EQ(opened.stacks().size(), 1u);
    EXPECT_EQ(opened.stacks()[0]->frames[0].frameOfReferenceUid, "2.25.1777")
        << "and not that of the patient";
}

TEST_F(D13MultiFrame, OfOtherProgramsInOneFile) {
    SKIP_WITHOUT_SHARED_DATA();
    for (const auto& [name, key] :
         {std::pair("us-volume", key::kSidesUnknown), std::pair("cbct-single-spacing", key::kFramesInARow)}) {
        SCOPED_TRACE(name);
        const Opened opened(sharedData() / "failures/other" / name);
        const auto volumes = opened.volumes();
        ASSERT_EQ(volumes.size(), 1u) << opened.keys();
        EXPECT_EQ(volumes[0]->slices.size(), 24u);
        EXPECT_NEAR(glm::length(*volumes[0]->spacingMm - glm::dvec3(0.7, 0.9, 2.0)), 0.0, 1e-9);
        EXPECT_EQ(*volumes[0]->firstPositionMm, glm::dvec3(-10, -20, -100));
        EXPECT_TRUE(opened.says(key)) << opened.keys();
        EXPECT_NE(opened.load(*volumes[0]), nullptr);
    }
}

TEST_F(D14SecondaryCapture, WithGeometryIsAVolume) {
    series.modality = "OT";
    series.imageType = "DERIVED\\SECONDARY";
    series.intercept = 0.0;
    writeMultiFrame(folder / "capture", series, slicesOf(series));
    expectOnlyVolume(open(), series);
}

TEST_F(D14SecondaryCapture, WithoutGeometryIsPictures) {
    series.modality = "OT";
    series.imageType = "DERIVED\\SECONDARY";
    series.intercept = 0.0;
    writeMultiFrame(folder / "capture", series, slicesOf(series),
                    {.functionalGroups = false, .dimensions = false});
    const Opened opened = open();
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_EQ(opened.frames(), 12u);
    EXPECT_TRUE(opened.says(key::kMultiFrameNoPosition) || opened.says(key::kMultiFrameNoPixelMeasures) ||
                opened.says(key::kMultiFrameNoOrientation))
        << opened.keys();
}

TEST_F(D14SecondaryCapture, SingleFramesWithGeometry) {
    series.modality = "OT";
    series.sopClassUid = "1.2.840.10008.5.1.4.1.1.7";
    series.imageType = "DERIVED\\SECONDARY";
    writeFiles(folder.path(), series);
    expectOnlyVolume(open(), series);
}

// One image in several files (PS3.3 C.7.6.16.2.2.4).
Edit part(int number, int total, std::size_t offset) {
    return [=](DcmItem& item) {
        put(item, DCM_ConcatenationUID, "2.25.6000");
        put(item, DCM_SOPInstanceUIDOfConcatenationSource, "2.25.6001");
        putWord(item, DCM_InConcatenationNumber, number);
        putWord(item, DCM_InConcatenationTotalNumber, total);
        putNumber(item, DCM_ConcatenationFrameOffsetNumber, static_cast<double>(offset));
    };
}

TEST_F(D08Concatenation, FilesOfOneImageAreOneVolume) {
    series.modality = "CT";
    const auto slices = slicesOf(series);
    const std::vector<Slice> first(slices.begin(), slices.begin() + 5);
    const std::vector<Slice> second(slices.begin() + 5, slices.end());
    writeMultiFrame(folder / "b", series, first, {.sopInstanceUid = "2.25.6002", .edits = {part(1, 2, 0)}});
    writeMultiFrame(folder / "a", series, second, {.sopInstanceUid = "2.25.6003", .edits = {part(2, 2, 5)}});
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_EQ(opened.stacks().size(), 1u);
    EXPECT_FALSE(opened.says(key::kIncompleteConcatenation));
}

TEST_F(D08Concatenation, AFileThatIsMissingIsTold) {
    const auto slices = slicesOf(series);
    writeMultiFrame(folder / "a", series, {slices.begin(), slices.begin() + 4},
                    {.sopInstanceUid = "2.25.6002", .edits = {part(1, 3, 0)}});
    writeMultiFrame(folder / "c", series, {slices.begin() + 8, slices.end()},
                    {.sopInstanceUid = "2.25.6004", .edits = {part(3, 3, 8)}});
    const Opened opened = open();
    const Message* told = opened.find(key::kIncompleteConcatenation);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_EQ(numberArgument(*told, "missing"), 1.0);
    EXPECT_EQ(numberArgument(*told, "total"), 3.0);
    EXPECT_EQ(opened.frames(), 8u);
    for (const Stack* stack : opened.volumes()) {
        const auto volume = opened.load(*stack);
        ASSERT_NE(volume, nullptr);
        expectRamp(*volume, series.rampOf(), 1.0);
    }
}

}  // namespace
}  // namespace macula::dicom::test
