// D5: several images at one position.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "opened.h"

namespace macula::dicom::test {
namespace {

using D05DuplicatePositions = Pitfall;

namespace fs = std::filesystem;

// The phases of a series that has three, each marked by an edit.
template <class Mark>
void expectSplitBy(SyntheticSeries series, std::string_view attribute, Mark mark) {
    SCOPED_TRACE(attribute);
    const TemporaryFolder folder;
    series.phases = 3;
    series.size.z = 6;
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.edits.push_back([&slice, &mark](DcmItem& item) { mark(item, slice.phase, slice.place); });
    }
    writeFiles(folder.path(), series, slices);
    const Opened opened(folder.path());
    expectPhases(opened, series);
    EXPECT_TRUE(opened.says(key::kPhases) || opened.says(key::kSplitSeries)) << opened.keys();
    EXPECT_FALSE(opened.says(key::kPhasesAssumed)) << opened.keys();
    EXPECT_FALSE(opened.says(key::kDuplicatePositions)) << opened.keys();
    for (const Message* message : {opened.find(key::kPhases), opened.find(key::kSplitSeries)}) {
        if (message) {
            EXPECT_NE(message->sentence.english().find(attribute), std::string::npos) << message->sentence;
        }
    }
}

std::string clock(double seconds) {
    return fmt::format("{:02}{:02}{:09.6f}", 10 + static_cast<int>(seconds) / 3600,
                       static_cast<int>(seconds) / 60 % 60, seconds - 60 * (static_cast<int>(seconds) / 60));
}

void putBValueOfGe(DcmItem& item, const std::string& values) {
    ASSERT_TRUE(item.putAndInsertString(DcmTag(0x0043, 0x0010, EVR_LO), "GEMS_PARM_01").good());
    ASSERT_TRUE(item.putAndInsertString(DcmTag(0x0043, 0x1039, EVR_IS), values.c_str()).good());
}

TEST_F(D05DuplicatePositions, TemporalPosition) {
    series.modality = "MR";
    expectSplitBy(series, "TemporalPosition", [](DcmItem& item, int phase, int) {
        put(item, DCM_TemporalPositionIdentifier, std::to_string(phase + 1));
    });
}

// Times of a gated acquisition are not equal at any two positions.
TEST_F(D05DuplicatePositions, JitteredTriggerTime) {
    series.modality = "MR";
    expectSplitBy(series, "TriggerTime", [](DcmItem& item, int phase, int place) {
        putNumber(item, DCM_TriggerTime, 100.0 + 250.0 * phase + 7.25 * ((place * 5) % 6));
    });
}

TEST_F(D05DuplicatePositions, EchoTime) {
    series.modality = "MR";
    expectSplitBy(series, "EchoTime",
                  [](DcmItem& item, int phase, int) { putNumber(item, DCM_EchoTime, 4.6 + 2.3 * phase); });
}

TEST_F(D05DuplicatePositions, BValue) {
    series.modality = "MR";
    expectSplitBy(series, "DiffusionBValue",
                  [](DcmItem& item, int phase, int) { putNumber(item, DCM_DiffusionBValue, 500.0 * phase); });
}

// GE keeps it in a private element, with 1e9 added where a series has several, and with other numbers behind.
TEST_F(D05DuplicatePositions, PrivateBValueOfGeIsWithoutWhatWasAdded) {
    series.modality = "MR";
    series.phases = 3;
    series.size.z = 6;
    auto slices = slicesOf(series);
    const char* values[] = {"0\\8\\0\\0", "1000000500\\8\\0\\0", "1000012000\\8\\0\\0"};
    for (Slice& slice : slices) {
        slice.edits.push_back(
            [&values, phase = slice.phase](DcmItem& item) { putBValueOfGe(item, values[phase]); });
    }
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    expectPhases(opened, series);
    std::vector<std::string> said;
    for (const Stack* stack : opened.volumes()) {
        for (const StackLabel& label : stack->splitBy)
            if (label.attribute == "DiffusionBValue") said.push_back(label.value);
    }
    EXPECT_EQ(said, (std::vector<std::string>{"0", "500", "12000"}));
}

// One image has the standard's attribute, another only that of GE: the same b-value is the same.
TEST_F(D05DuplicatePositions, BValueOfGeIsComparedWithThatOfTheStandard) {
    series.modality = "MR";
    expectSplitBy(series, "DiffusionBValue", [](DcmItem& item, int phase, int place) {
        if (place % 2 == 0) {
            putNumber(item, DCM_DiffusionBValue, 400.0 * phase);
            return;
        }
        putBValueOfGe(item, std::to_string(1000000000 + 400 * phase) + "\\8\\0\\0");
    });
}

TEST_F(D05DuplicatePositions, AcquisitionNumber) {
    expectSplitBy(series, "AcquisitionNumber", [](DcmItem& item, int phase, int) {
        put(item, DCM_AcquisitionNumber, std::to_string(phase + 1));
    });
}

TEST_F(D05DuplicatePositions, ImageType) {
    series.modality = "MR";
    expectSplitBy(series, "ImageType", [](DcmItem& item, int phase, int) {
        const char* types[] = {"ORIGINAL\\PRIMARY\\F_FFE", "ORIGINAL\\PRIMARY\\M_FFE",
                               "ORIGINAL\\PRIMARY\\W_FFE"};
        put(item, DCM_ImageType, types[phase]);
    });
}

// A perfusion scan: each slice has the time at which it was taken.
TEST_F(D05DuplicatePositions, AcquisitionTime) {
    expectSplitBy(series, "Time", [](DcmItem& item, int phase, int place) {
        put(item, DCM_AcquisitionTime, clock(30.0 * phase + 0.4 * place));
    });
}

TEST_F(D05DuplicatePositions, ContentTime) {
    expectSplitBy(series, "ContentTime", [](DcmItem& item, int phase, int place) {
        put(item, DCM_ContentTime, clock(30.0 * phase + 0.4 * place));
    });
}

TEST_F(D05DuplicatePositions, CardiacPhase) {
    expectSplitBy(series, "CardiacPhase", [](DcmItem& item, int phase, int) {
        putNumber(item, DCM_NominalPercentageOfCardiacPhase, 10.0 + 30.0 * phase);
    });
}

// Two properties at once: every combination is a volume.
TEST_F(D05DuplicatePositions, EchoesAndTimes) {
    series.modality = "MR";
    series.phases = 4;
    series.size.z = 5;
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.edits.push_back([phase = slice.phase](DcmItem& item) {
            putNumber(item, DCM_EchoTime, phase < 2 ? 5.0 : 10.0);
            put(item, DCM_TemporalPositionIdentifier, std::to_string(phase % 2 + 1));
        });
    }
    writeFiles(folder.path(), series, slices);
    expectPhases(open(), series);
}

// Diffusion: one image without weighting, and six directions of one b-value.
TEST_F(D05DuplicatePositions, DiffusionDirections) {
    series.modality = "MR";
    series.phases = 7;
    series.size.z = 5;
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.edits.push_back([phase = slice.phase](DcmItem& item) {
            putNumber(item, DCM_DiffusionBValue, phase == 0 ? 0.0 : 1000.0);
            if (phase == 0) return;
            const double a = 0.4 * phase;
            const Float64 direction[] = {std::cos(a), std::sin(a), 0.0};
            item.putAndInsertFloat64Array(DCM_DiffusionGradientOrientation, direction, 3);
        });
    }
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 35u);
    EXPECT_FALSE(opened.says(key::kPhasesAssumed)) << opened.keys();
    expectPhasesInAnyOrder(opened, series);
}

// Magnitude and phase images of two echoes: two attributes, four volumes.
TEST_F(D05DuplicatePositions, ImageTypesOfTwoEchoes) {
    series.modality = "MR";
    series.phases = 4;
    series.size.z = 5;
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.edits.push_back([phase = slice.phase](DcmItem& item) {
            put(item, DCM_ImageType, phase < 2 ? "ORIGINAL\\PRIMARY\\M" : "ORIGINAL\\PRIMARY\\P");
            putNumber(item, DCM_EchoTime, phase % 2 ? 10.0 : 5.0);
        });
    }
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_FALSE(opened.says(key::kPhasesAssumed)) << opened.keys();
    expectPhasesInAnyOrder(opened, series);
}

// What is found does not depend on how the files are called, nor in which order they lie.
TEST_F(D05DuplicatePositions, NamesDecideNothing) {
    series.modality = "MR";
    series.phases = 3;
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.edits.push_back([phase = slice.phase, place = slice.place](DcmItem& item) {
            putNumber(item, DCM_TriggerTime, 100.0 + 250.0 * phase + 7.25 * ((place * 5) % 6));
        });
    }
    slices.erase(slices.begin() + 17);
    slices.push_back(slices[3]);
    slices.back().sopInstanceUid += ".7";
    const auto described = [&](unsigned seed) {
        const TemporaryFolder own;
        std::shuffle(slices.begin(), slices.end(), std::mt19937(seed));
        for (std::size_t n = 0; n < slices.size(); ++n) slices[n].fileName = fmt::format("f{}", n);
        writeFiles(own.path(), series, slices);
        const Opened opened(own.path());
        std::string all = opened.keys();
        for (const Stack* stack : opened.stacks()) {
            all += "|";
            for (const Frame& frame : stack->frames) all += frame.instance->sopInstanceUid + " ";
        }
        return all;
    };
    const std::string first = described(1);
    for (unsigned seed = 2; seed < 6; ++seed) EXPECT_EQ(described(seed), first);
}

// Nothing tells them apart but the order of the numbers: shown, with a warning.
TEST_F(D05DuplicatePositions, OnlyBlocksOfInstanceNumbers) {
    series.phases = 2;
    series.shuffleNumbers = false;
    writeFiles(folder.path(), series);
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 24u);
    if (opened.volumes().empty()) {
        EXPECT_TRUE(opened.says(key::kDuplicatePositions)) << opened.keys();
    } else {
        EXPECT_TRUE(opened.says(key::kPhasesAssumed)) << opened.keys();
        expectPhases(opened, series);
    }
}

// Numbers position by position: 1 2 for the first, 3 4 for the second.
TEST_F(D05DuplicatePositions, InterleavedInstanceNumbers) {
    series.phases = 2;
    auto slices = slicesOf(series);
    for (Slice& slice : slices) slice.instanceNumber = slice.place * 2 + slice.phase + 1;
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 24u);
    EXPECT_TRUE(opened.says(key::kPhasesAssumed)) << opened.keys();
    expectPhases(opened, series);
}

// Numbers without any order: either a question, or an assumption that is said.
TEST_F(D05DuplicatePositions, NothingTellsThemApart) {
    series.phases = 2;
    auto slices = slicesOf(series);
    for (Slice& slice : slices) slice.edits.push_back([](DcmItem& item) { erase(item, DCM_InstanceNumber); });
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 24u);
    EXPECT_TRUE(opened.volumes().empty()) << "which image belongs to which volume was guessed";
    const Message* question = opened.find(key::kDuplicatePositions);
    ASSERT_NE(question, nullptr) << opened.keys();
    EXPECT_EQ(question->severity, Severity::blocksVolume);
    EXPECT_EQ(numberArgument(*question, "total"), 24.0);
}

TEST_F(D05DuplicatePositions, TheSameFileTwiceIsDropped) {
    const auto files = writeFiles(folder.path(), series);
    fs::create_directories(folder / "backup");
    for (const fs::path& file : files) fs::copy_file(file, folder / "backup" / file.filename());
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_EQ(opened.frames(), 12u);
    const Message* told = opened.find(key::kDuplicateFiles);
    ASSERT_NE(told, nullptr);
    EXPECT_EQ(numberArgument(*told, "count"), 12.0);
}

// One UID, other bytes: one of them is wrong, and nobody can say which.
TEST_F(D05DuplicatePositions, OneUidWithOtherPixelsIsKept) {
    auto slices = slicesOf(series);
    Slice twin = slices[4];
    twin.phase = 1;  // other values
    twin.fileName = "twin";
    slices.push_back(twin);
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 13u);
    EXPECT_TRUE(opened.says(key::kDuplicateInstances)) << opened.keys();
    expectOnlyVolume(opened, series);
}

// Slice 4 was taken again: the volume is whole, and the second image is not lost.
TEST_F(D05DuplicatePositions, OneRepeatedSlice) {
    auto slices = slicesOf(series);
    Slice again = slices[4];
    again.phase = 1;
    again.instanceNumber = 99;
    again.sopInstanceUid += ".99";
    again.fileName = "again";
    slices.push_back(again);
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 13u);
    expectOnlyVolume(opened, series);
    const Message* told = opened.find(key::kRepeatedSlices);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_EQ(numberArgument(*told, "count"), 1.0);
}

// The last phase was stopped half way: the whole ones are volumes of their own.
TEST_F(D05DuplicatePositions, LastPhaseIncomplete) {
    series.modality = "MR";
    series.phases = 3;
    auto slices = slicesOf(series);
    slices.resize(30);
    for (Slice& slice : slices) {
        slice.edits.push_back([phase = slice.phase](DcmItem& item) {
            put(item, DCM_TemporalPositionIdentifier, std::to_string(phase + 1));
        });
    }
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 30u);
    const auto volumes = opened.volumes();
    ASSERT_GE(volumes.size(), 2u) << opened.keys();
    for (std::size_t phase = 0; phase < volumes.size(); ++phase) {
        const auto volume = opened.load(*volumes[phase]);
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->size().z, phase < 2 ? 12 : 6);
        expectRamp(*volume, series.rampOf(static_cast<int>(phase)));
    }
}

// A film at one position: pictures, no volume.
TEST_F(D05DuplicatePositions, CineAtOnePositionIsNoVolume) {
    series.modality = "MR";
    series.phases = 20;
    series.size.z = 1;
    series.phaseStep = 10.0;
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.edits.push_back(
            [phase = slice.phase](DcmItem& item) { putNumber(item, DCM_TriggerTime, 40.0 * phase); });
    }
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_EQ(opened.frames(), 20u);
    EXPECT_TRUE(opened.says(key::kSingleSlice) || opened.says(key::kDuplicatePositions)) << opened.keys();
}

}  // namespace
}  // namespace macula::dicom::test
