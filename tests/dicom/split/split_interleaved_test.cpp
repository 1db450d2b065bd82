// The rules for slices that interleave, for frames of reference, and for what changes along a stack.
#include <gtest/gtest.h>

#include <algorithm>

#include "dicom/split/split.h"
#include "frames_by_hand.h"

namespace macula::dicom {
namespace {

using namespace test;

void setFrameOfReference(Frames& made, const std::string& uid) {
    made.set("FrameOfReferenceUID", uid);
    made.frames.back().frameOfReferenceUid = uid;
}

// That two slices share one says that it means something.
TEST(Split, FramesOfReferenceThatSlicesShareAreNeverJoined) {
    Frames made;
    for (int k = 0; k < 12; ++k) {
        made.add(2.0 * k);
        setFrameOfReference(made, "1.2." + std::to_string(k / 2));
    }
    for (const Stack& stack : splitOf(made).stacks) EXPECT_LE(stack.frames.size(), 2u);
}

TEST(Split, AFrameOfReferencePerSliceIsNone) {
    Frames made;
    for (int k = 0; k < 12; ++k) {
        made.add(2.0 * k);
        setFrameOfReference(made, "1.2." + std::to_string(k));
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 1u) << keys(split);
    EXPECT_TRUE(split.stacks[0].isEven());
    EXPECT_TRUE(has(split.stacks[0].messages, key::kFrameOfReferencePerSlice));
    for (const Frame& frame : split.stacks[0].frames) EXPECT_TRUE(frame.frameOfReferenceUid.empty());
}

TEST(Split, AFrameOfReferencePerSliceOfAnUnevenStackIsTakenAtItsWord) {
    Frames made;
    for (int k = 0; k < 12; ++k) {
        made.add(2.0 * k + (k % 3 == 0 ? 0.7 : 0.0));
        setFrameOfReference(made, "1.2." + std::to_string(k));
    }
    for (const Stack& stack : splitOf(made).stacks) EXPECT_FALSE(stack.canBeVolume());
}

TEST(Split, AFrameOfReferenceThatSomeSlicesLackIsTheirs) {
    Frames made;
    for (int k = 0; k < 12; ++k) {
        made.add(2.0 * k);
        if (k != 4 && k != 5) setFrameOfReference(made, "1.2.3");
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 1u) << keys(split);
    EXPECT_TRUE(has(split.stacks[0].messages, key::kFrameOfReferenceMissing));
}

// Every other slice names one, and together they are even: a writer that forgot, and said.
TEST(Split, AFrameOfReferenceInEveryOtherSliceIsTheirs) {
    Frames made;
    for (int k = 0; k < 12; ++k) {
        made.add(2.0 * k);
        if (k % 2 == 0) setFrameOfReference(made, "1.2.3");
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 1u) << keys(split);
    EXPECT_TRUE(has(split.stacks[0].messages, key::kFrameOfReferenceMissing));
}

TEST(Split, StacksEndToEndAreOneVolumeAndInterleavedOnesAreNot) {
    for (const bool interleaved : {false, true}) {
        Frames made;
        for (int k = 0; k < 24; ++k) {
            made.add(2.0 * k);
            made.set("StackID", std::to_string(interleaved ? k % 3 : k / 8));
        }
        const Split split = splitOf(made);
        ASSERT_EQ(split.stacks.size(), interleaved ? 3u : 1u) << keys(split);
        EXPECT_EQ(has(split.stacks[0].messages, key::kStacksJoined), !interleaved);
    }
}

// 16 pixels of 1 mm: 0.002 rad move a corner by 0.04 mm, 0.01 by 0.2 mm, and 0.1 by 2 mm.
TEST(Split, DirectionsThatDriftAreOneWhileNoVoxelMoves) {
    for (const auto& [radians, stacks] : {std::pair(0.002, 1), std::pair(0.01, 1), std::pair(0.1, 12)}) {
        Frames made;
        for (int k = 0; k < 12; ++k) {
            Frame& frame = made.add(2.0 * k);
            const double angle = radians * (k % 2 == 0 ? 1.0 : -1.0) * (1.0 + k / 100.0);
            frame.plane->rowDirection = {std::cos(angle), std::sin(angle), 0};
            frame.plane->columnDirection = {-std::sin(angle), std::cos(angle), 0};
            made.set("ImageOrientationPatient", std::to_string(angle));
        }
        const Split split = splitOf(made);
        if (stacks > 1) {
            EXPECT_GT(split.stacks.size(), 0u);
            for (const Stack& stack : split.stacks) EXPECT_FALSE(stack.isEven() && stack.frames.size() == 12);
            continue;
        }
        ASSERT_EQ(split.stacks.size(), 1u) << keys(split);
        EXPECT_TRUE(split.stacks[0].isEven());
        const auto& messages = split.stacks[0].messages;
        const auto told = std::ranges::find(messages, key::kOrientationDrift, &Message::key);
        ASSERT_NE(told, messages.end()) << keys(split);
        EXPECT_EQ(told->severity, radians < 0.005 ? Severity::info : Severity::warning);
    }
}

// Slices of 2D MR that do not overlap, odd and even ones in passes of their own.
TEST(Split, AnInterleavedAcquisitionStaysWhole) {
    for (const bool overlap : {false, true}) {
        Frames made;
        for (int k = 0; k < 12; ++k) {
            made.add(2.5 * k).sliceThicknessMm = overlap ? 5.0 : 2.5;
            made.set("AcquisitionNumber", k % 2 ? "1" : "2");
        }
        EXPECT_EQ(splitOf(made, "MR").stacks.size(), overlap ? 2u : 1u);
        EXPECT_EQ(splitOf(made, "CT").stacks.size(), 2u);
    }
}

TEST(Split, OneOfTwoInterleavedAcquisitionsLacksASlice) {
    Frames made;
    for (int k = 0; k < 24; ++k) {
        if (k == 7) continue;
        made.add(1.25 * k);
        made.set("AcquisitionNumber", k % 2 ? "1" : "2");
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 2u) << keys(split);
    EXPECT_EQ(split.stacks[1].frames.size(), 12u);
}

// A step: kernel in a block in the middle, acquisitions one above the other. Many acquisitions are a table
// that moves between them.
TEST(Split, ChangesAlongAStackAreWarnedOf) {
    Frames made;
    for (int k = 0; k < 12; ++k) {
        made.add(2.0 * k);
        made.set("ConvolutionKernel", k >= 4 && k < 8 ? "B30" : "B70")
            .set("AcquisitionNumber", std::to_string(k / 2));
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 1u) << keys(split);
    const auto& messages = split.stacks[0].messages;
    ASSERT_EQ(std::count_if(messages.begin(), messages.end(),
                            [](const Message& m) { return m.key == key::kChangesAlongStack; }),
              1);
    const auto told = std::find_if(messages.begin(), messages.end(),
                                   [](const Message& m) { return m.key == key::kChangesAlongStack; });
    EXPECT_NE(told->sentence.english().find("ConvolutionKernel changes along the slices, first at slice 5"),
              std::string::npos)
        << told->sentence;
}

// A volume that lacks slices is not taken for two.
TEST(Split, MissingSlicesAreNoSecondLattice) {
    for (const int missing : {1, 6, 11}) {
        Frames made;
        for (int k = 0; k < 14; ++k) {
            if (k != missing) made.add(2.0 * k);
        }
        EXPECT_EQ(splitOf(made).stacks.size(), 1u) << missing;
    }
}

}  // namespace
}  // namespace macula::dicom
