// What tells the frames of one multi-frame file apart, beyond D13: gradients, dimensions, and the lists of
// nuclear medicine; and what is in it and says nothing of frames.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <random>

#include "opened.h"

namespace macula::dicom::test {
namespace {

class FrameLists : public Pitfall {
  protected:
    FrameLists() { series.modality = "MR"; }

    std::vector<Slice> shuffled() const {
        auto slices = slicesOf(series);
        std::shuffle(slices.begin(), slices.end(), std::mt19937(11));
        return slices;
    }
    // No attribute tells the phases apart: what does is in the indices by dimension.
    std::vector<Slice> shuffledWithoutTimes() const {
        auto slices = shuffled();
        for (Slice& slice : slices) {
            slice.edits.push_back([](DcmItem& groups) {
                erase(nested(groups, DCM_FrameContentSequence), DCM_TemporalPositionIndex);
            });
        }
        return slices;
    }
};

// An item of a private sequence with standard attributes that are not those of the frame.
void putPrivateItem(DcmItem& groups, Uint16 group) {
    ASSERT_TRUE(groups.putAndInsertString(DcmTag(group, 0x0014, EVR_LO), "VENDOR").good());
    auto* sequence = new DcmSequenceOfItems(DcmTag(group, 0x140F, EVR_SQ));
    ASSERT_TRUE(groups.insert(sequence, OFTrue).good());
    auto* item = new DcmItem();
    ASSERT_TRUE(sequence->insert(item).good());
    put(*item, DCM_ImagePositionPatient, "1\\2\\3");
    put(*item, DCM_ImageOrientationPatient, "0\\1\\0\\1\\0\\0");
    put(*item, DCM_PixelSpacing, "9\\9");
    put(*item, DCM_RescaleSlope, "7");
    put(*item, DCM_RescaleIntercept, "-5");
    put(*item, DCM_WindowCenter, "1");
    put(*item, DCM_WindowWidth, "2");
}

// What is in private sequences means what their owner says (PS3.5 7.8). Those of Philips and Siemens stand
// before the shared functional groups, and by their tags before some of the frame's own.
TEST_F(FrameLists, PrivateSequencesAreNoFunctionalGroups) {
    for (const Uint16 group : {Uint16{0x0021}, Uint16{0x2005}}) {
        for (const bool shared : {true, false}) {
            SCOPED_TRACE(fmt::format("{:04x} {}", group, shared));
            const TemporaryFolder own;
            auto slices = shuffled();
            for (Slice& slice : slices)
                slice.edits.push_back([group](DcmItem& groups) { putPrivateItem(groups, group); });
            const Edit ofAll = [group](DcmItem& item) {
                putPrivateItem(nested(item, DCM_SharedFunctionalGroupsSequence), group);
            };
            writeMultiFrame(own / "enhanced", series, slices,
                            {.sharedMeasures = shared,
                             .sharedOrientation = shared,
                             .sharedTransformation = shared,
                             .edits = {ofAll}});
            const Opened opened(own.path());
            expectOnlyVolume(opened, series);
            const auto volume = opened.onlyVolume();
            ASSERT_NE(volume, nullptr);
            EXPECT_TRUE(volume->windows().empty());
        }
    }
}

// Diffusion (PS3.3 C.8.13.5.9): one image without, and three directions at each of two strengths. The
// direction is in a sequence of the macro.
TEST_F(FrameLists, GradientsOfSeveralStrengths) {
    series.phases = 7;
    auto slices = shuffled();
    for (Slice& slice : slices) {
        slice.edits.push_back([phase = slice.phase](DcmItem& groups) {
            DcmItem& diffusion = nested(groups, DCM_MRDiffusionSequence);
            putNumber(diffusion, DCM_DiffusionBValue, phase == 0 ? 0.0 : phase < 4 ? 500.0 : 1000.0);
            if (phase == 0) return;
            Float64 direction[3]{};
            direction[(phase - 1) % 3] = 1.0;
            DcmItem& gradient = nested(diffusion, DCM_DiffusionGradientDirectionSequence);
            auto* element = new DcmFloatingPointDouble(DCM_DiffusionGradientOrientation);
            ASSERT_TRUE(element->putFloat64Array(direction, 3).good());
            ASSERT_TRUE(gradient.insert(element).good());
        });
    }
    writeMultiFrame(folder / "enhanced", series, slices, {.dimensions = false});
    expectPhasesInAnyOrder(open(), series);
}

// PS3.3 C.7.6.17: indices by dimension tell frames apart where no attribute that is known does.
TEST_F(FrameLists, DimensionsThatNothingElseTellsOf) {
    series.phases = 3;
    const auto slices = shuffledWithoutTimes();
    writeMultiFrame(folder / "enhanced", series, slices);
    const Opened opened = open();
    expectPhases(opened, series);
    const Message* told = opened.find(key::kPhases);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_NE(told->sentence.english().find("DimensionIndexValues"), std::string::npos) << told->sentence;
}

// What is the same in all frames, or says where they lie, changes no order: the tenth comes after the second.
TEST_F(FrameLists, PhasesOfSeveralDimensionsAreInTheirOrder) {
    series.phases = 11;
    series.size.z = 3;
    for (const DcmTagKey& ofPlace : {DCM_InStackPositionNumber, DCM_PlanePositionVolumeSequence}) {
        SCOPED_TRACE(ofPlace.toString().c_str());
        const TemporaryFolder own;
        auto slices = shuffled();
        for (Slice& slice : slices) {
            slice.edits.push_back([phase = slice.phase, place = slice.place](DcmItem& groups) {
                DcmItem& content = nested(groups, DCM_FrameContentSequence);
                erase(content, DCM_TemporalPositionIndex);
                erase(content, DCM_DimensionIndexValues);
                const Uint32 values[] = {5, static_cast<Uint32>(place + 1), static_cast<Uint32>(phase + 1)};
                auto* element = new DcmUnsignedLong(DCM_DimensionIndexValues);
                ASSERT_TRUE(element->putUint32Array(values, 3).good());
                ASSERT_TRUE(content.insert(element).good());
            });
        }
        const Edit pointers = [&](DcmItem& item) {
            erase(item, DCM_DimensionIndexSequence);
            for (const DcmTagKey& pointer : {DCM_EffectiveEchoTime, ofPlace, DCM_TemporalPositionIndex}) {
                DcmItem& index = appended(item, DCM_DimensionIndexSequence);
                ASSERT_TRUE(index.putAndInsertTagKey(DCM_DimensionIndexPointer, pointer).good());
            }
        };
        writeMultiFrame(own / "enhanced", series, slices, {.edits = {pointers}});
        expectPhases(Opened(own.path()), series);
    }
}

// Without pointers nobody knows which of the indices is the place.
TEST_F(FrameLists, IndicesWithoutDimensionsSayNothing) {
    series.phases = 2;
    const auto slices = shuffledWithoutTimes();
    writeMultiFrame(folder / "enhanced", series, slices,
                    {.edits = {[](DcmItem& item) { erase(item, DCM_DimensionIndexSequence); }}});
    const Opened opened = open();
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_TRUE(opened.says(key::kDuplicatePositions)) << opened.keys();
}

// Nuclear medicine (PS3.3 C.8.4.8): a frame for each slice of each part of the heartbeat, or energy window.
class Nuclear : public FrameLists {
  protected:
    Nuclear() {
        series.modality = "NM";
        series.sopClassUid = "1.2.840.10008.5.1.4.1.1.20";
        series.size = {6, 5, 9};
        series.writeRescale = false;
        series.intercept = 0.0;
        series.imageType = "ORIGINAL\\PRIMARY\\RECON GATED TOMO\\EMISSION";
        series.worldFromVoxel = affine({4, 0, 0}, {0, 4.5, 0}, {0, 0, 5}, {-10, -20, -30});
        series.ramp = Ramp{.throughMm = {0, 0, 0}, .perMm = {11, 23, 17}};
    }

    // The vector `tag` has the phase of each frame, from 1.
    void write(const DcmTagKey& tag, std::size_t valuesLess = 0) const {
        const auto slices = slicesOf(series);
        std::vector<Uint16> places;
        std::vector<Uint16> phases;
        for (const Slice& slice : slices) {
            places.push_back(static_cast<Uint16>(slice.place + 1));
            phases.push_back(static_cast<Uint16>(slice.phase + 1));
        }
        const auto put16 = [](DcmItem& item, const DcmTagKey& key, const std::vector<Uint16>& values) {
            ASSERT_TRUE(
                item.putAndInsertUint16Array(DcmTag(key, EVR_US), values.data(), values.size()).good());
        };
        phases.resize(phases.size() - valuesLess);
        writeMultiFrame(folder / "nm", series, slices,
                        {.functionalGroups = false,
                         .dimensions = false,
                         .edits = {[&](DcmItem& item) {
                             put(item, DCM_PixelSpacing, "4.5\\4");
                             put(item, DCM_SpacingBetweenSlices, "5");
                             put16(item, DCM_SliceVector, places);
                             put16(item, tag, phases);
                             DcmItem& detector = nested(item, DCM_DetectorInformationSequence);
                             put(detector, DCM_ImagePositionPatient, "-10\\-20\\-30");
                             put(detector, DCM_ImageOrientationPatient, "1\\0\\0\\0\\1\\0");
                         }}});
    }
};

TEST_F(Nuclear, PartsOfTheHeartbeat) {
    series.phases = 4;
    write(DCM_TimeSlotVector);
    const Opened opened = open();
    expectPhases(opened, series);
    EXPECT_EQ(opened.volumes().back()->phases, 4);
    EXPECT_TRUE(opened.says(key::kPhases)) << opened.keys();
}

TEST_F(Nuclear, EnergyWindows) {
    series.phases = 2;
    write(DCM_EnergyWindowVector);
    expectPhases(open(), series);
}

// A list that is too short says nothing for sure of any frame.
TEST_F(Nuclear, AListThatIsTooShort) {
    series.phases = 2;
    write(DCM_TimeSlotVector, 1);
    const Opened opened = open();
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_TRUE(opened.says(key::kDuplicatePositions)) << opened.keys();
    EXPECT_EQ(opened.frames(), 18u);
}

}  // namespace
}  // namespace macula::dicom::test
