// The rules by which the frames of a series fall into stacks, on frames made by hand.
#include "dicom/split/split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "frames_by_hand.h"

namespace macula::dicom {
namespace {

using namespace test;

TEST(Split, EveryAttributeOfTheRulesHasItsTagsAndMessages) {
    const SplitRules& rules = splitRules();
    EXPECT_GE(rules.hard.size(), 10u);
    EXPECT_GE(rules.soft.size(), 15u);
    EXPECT_GE(rules.phases.size(), 8u);
    for (const Attribute& a : rules.attributes) EXPECT_FALSE(a.tags.empty()) << a.name;
    for (const SplitRules::Hard& rule : rules.hard) {
        const auto entries = catalogue();
        EXPECT_TRUE(std::any_of(entries.begin(), entries.end(), [&](const CatalogueEntry& e) {
            return e.key == rule.message;
        })) << rule.message;
    }
    EXPECT_TRUE(rules.phases.back().assumed);  // the image number comes last
}

TEST(Split, AVolumeIsKeptWholeWhateverItsAttributes) {
    Frames made;
    for (int k = 0; k < 12; ++k) {
        made.add(2.0 * k);
        made.set("AcquisitionNumber", std::to_string(k / 3)).set("ConvolutionKernel", k < 6 ? "B30" : "B70");
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 1u) << keys(split);
    EXPECT_TRUE(split.stacks[0].isEven());
    EXPECT_TRUE(split.messages.empty());
}

TEST(Split, HalvesOfAVolumeWithAGapAreOneVolume) {
    Frames made;
    for (int k = 0; k < 20; ++k) {
        if (k == 9) continue;
        made.add(2.0 * k);
        made.set("AcquisitionNumber", k < 9 ? "1" : "2");
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 1u) << keys(split);
    EXPECT_TRUE(has(split.stacks[0].messages, key::kMissingSlices));
}

TEST(Split, TwoKernelsAtTheSamePositions) {
    Frames made;
    for (int k = 0; k < 10; ++k) {
        for (const char* kernel : {"B30f", "B70f"}) {
            made.add(1.5 * k);
            made.set("ConvolutionKernel", kernel);
        }
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 2u) << keys(split);
    EXPECT_TRUE(has(split.messages, key::kSplitSeries));
    EXPECT_EQ(split.stacks[0].splitBy, (std::vector<StackLabel>{{"ConvolutionKernel", "B30f"}}));
    EXPECT_EQ(split.stacks[1].splitBy, (std::vector<StackLabel>{{"ConvolutionKernel", "B70f"}}));
    EXPECT_TRUE(split.stacks[0].isEven() && split.stacks[1].isEven());
}

TEST(Split, TwoKernelsAtInterleavedPositions) {
    Frames made;
    for (int k = 0; k < 10; ++k) {
        made.add(5.0 * k);
        made.set("ConvolutionKernel", "B30f");
        made.add(5.0 * k + 1.0);
        made.set("ConvolutionKernel", "B70f");
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 2u) << keys(split);
    EXPECT_DOUBLE_EQ(split.stacks[0].spacingMm->z, 5.0);
}

// Together they would be even slices 2.5 mm apart that alternate between two kernels.
TEST(Split, InterleavedKernelsThatMakeAnEvenVolume) {
    Frames made;
    for (int k = 0; k < 12; ++k) {
        made.add(2.5 * k);
        made.set("ConvolutionKernel", k % 2 ? "B30f" : "B70f");
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 2u) << keys(split);
    EXPECT_DOUBLE_EQ(split.stacks[0].spacingMm->z, 5.0);
}

// Three volumes of ten slices, one slice a second, across midnight.
TEST(Split, PhasesByTimeAcrossMidnight) {
    Frames made;
    for (int phase = 0; phase < 3; ++phase) {
        for (int k = 0; k < 10; ++k) {
            made.add(2.0 * k);
            const int second = 45 + 10 * phase + k;
            made.set("AcquisitionTime", second < 60 ? "20200101" + std::to_string(235900 + second)
                                                    : "202001020000" + std::string(second < 70 ? "0" : "") +
                                                          std::to_string(second - 60));
        }
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 3u) << keys(split);
    EXPECT_EQ(*split.stacks[0].frames.back().instance->instanceNumber, 10);
    EXPECT_EQ(*split.stacks[2].frames.front().instance->instanceNumber, 21);
}

TEST(Split, TemporalPositionsArePhasesWhateverElseDiffers) {
    Frames made;
    for (int phase = 1; phase <= 4; ++phase) {
        for (int k = 0; k < (phase == 3 ? 7 : 10); ++k) {
            made.add(2.0 * k);
            made.set("TemporalPositionIdentifier", std::to_string(phase))
                .set("AcquisitionNumber", std::to_string(phase));
        }
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 4u) << keys(split);
    EXPECT_EQ(split.stacks[0].phases, 4);
    EXPECT_TRUE(has(split.messages, key::kPhases));
    EXPECT_TRUE(has(split.messages, key::kIncompletePhases));
}

TEST(Split, RegionsWithTheirOwnTimesAreNoPhases) {
    Frames made;
    for (int region = 0; region < 2; ++region) {
        for (int k = 0; k < 10; ++k) {
            made.add(500.0 * region + 2.0 * k);
            made.set("AcquisitionTime", region == 0 ? "20200101100000" : "20200101100100");
        }
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 2u) << keys(split);
    EXPECT_EQ(split.stacks[0].phases, 1);
    EXPECT_FALSE(has(split.messages, key::kPhases));
}

TEST(Split, OfARepeatedPositionTheLowestNumberStays) {
    Frames made;
    for (int k = 0; k < 20; ++k) made.add(2.0 * k);
    made.add(9.9995);
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 2u) << keys(split);
    EXPECT_EQ(*split.stacks[1].frames[0].instance->instanceNumber, 21);
}

// Eleven attributes that differ in every frame: tried for a while, and not for minutes.
TEST(Split, FramesThatDifferInEverything) {
    Frames made;
    std::mt19937 random(3);
    for (int n = 0; n < 3000; ++n) {
        made.add(2.0 * (n % 700));
        for (const char* name : {"ImageType", "EchoTime", "DiffusionBValue", "FlipAngle", "RepetitionTime",
                                 "InversionTime", "SequenceName", "ScanOptions", "TriggerTime"}) {
            made.set(name, std::to_string(random() % 1000));
        }
    }
    const Split split = splitSeries(made.frames, "MR", splitRules());
    std::size_t total = 0;
    for (const Stack& stack : split.stacks) total += stack.frames.size();
    EXPECT_EQ(total, 3000u);
}

TEST(Split, MagnitudeAndPhaseOfTwoEchoes) {
    Frames made;
    for (const char* echo : {"2.46", "4.92"}) {
        for (const char* component : {"ORIGINAL\\PRIMARY\\M", "ORIGINAL\\PRIMARY\\P"}) {
            for (int k = 0; k < 8; ++k) {
                made.add(3.0 * k);
                made.set("EchoTime", echo).set("ImageType", component);
            }
        }
    }
    const Split split = splitOf(made, "MR");
    ASSERT_EQ(split.stacks.size(), 4u) << keys(split);
    for (const Stack& stack : split.stacks) {
        EXPECT_TRUE(stack.isEven());
        EXPECT_EQ(stack.splitBy.size(), 2u);
    }
}

TEST(Split, PhasesByValue) {
    Frames made;
    for (int phase = 10; phase >= 1; --phase) {
        for (int k = 0; k < 6; ++k) {
            made.add(2.0 * k);
            made.set("TemporalPositionIdentifier", std::to_string(phase));
        }
    }
    const Split split = splitOf(made, "MR");
    ASSERT_EQ(split.stacks.size(), 10u) << keys(split);
    EXPECT_TRUE(has(split.messages, key::kPhases));
    for (int phase = 0; phase < 10; ++phase) {
        const Stack& stack = split.stacks[static_cast<std::size_t>(phase)];
        EXPECT_EQ(stack.phase, phase);
        EXPECT_EQ(stack.phases, 10);
        EXPECT_EQ(stack.splitBy.back().value, std::to_string(phase + 1));  // as numbers: 10 after 9
    }
}

// A cardiac cine: each slice has its own heart beats, so no value is shared by two slices.
TEST(Split, PhasesByRankOfJitteredTriggerTimes) {
    Frames made;
    for (int k = 0; k < 7; ++k) {
        for (int phase = 0; phase < 20; ++phase) {
            made.add(8.0 * k);
            made.set("TriggerTime", std::to_string(40.0 * phase + 1.37 * k));
        }
    }
    const Split split = splitOf(made, "MR");
    ASSERT_EQ(split.stacks.size(), 20u) << keys(split);
    for (std::size_t phase = 0; phase < 20; ++phase) {
        for (const Frame& frame : split.stacks[phase].frames) {
            EXPECT_NEAR(std::stod(frame.attributes[attribute("TriggerTime")]), 40.0 * double(phase), 9.0);
        }
    }
}

TEST(Split, PhasesByNumberOnlyAreSaidToBeAssumed) {
    Frames made;
    for (int phase = 0; phase < 3; ++phase) {
        for (int k = 0; k < 6; ++k) made.add(2.0 * k);
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 3u) << keys(split);
    EXPECT_TRUE(has(split.messages, key::kPhasesAssumed));
    for (const Stack& stack : split.stacks) EXPECT_FALSE(stack.assumptions.empty());
}

TEST(Split, PhasesInEachOfTwoKernels) {
    Frames made;
    for (const char* kernel : {"soft", "sharp"}) {
        for (int phase = 1; phase <= 4; ++phase) {
            for (int k = 0; k < 5; ++k) {
                made.add(2.0 * k);
                made.set("ConvolutionKernel", kernel).set("TemporalPositionIndex", std::to_string(phase));
            }
        }
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 8u) << keys(split);
    for (const Stack& stack : split.stacks) {
        EXPECT_TRUE(stack.isEven());
        EXPECT_EQ(stack.phases, 4);
        EXPECT_EQ(stack.splitBy.size(), 2u);
    }
}

TEST(Split, AFewRepeatedSlicesAreSetApartAndSaid) {
    Frames made;
    for (int k = 0; k < 20; ++k) made.add(2.0 * k);
    made.add(10.0);
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 2u) << keys(split);
    EXPECT_EQ(split.stacks[0].frames.size(), 20u);
    EXPECT_TRUE(split.stacks[0].canBeVolume());
    EXPECT_TRUE(has(split.stacks[0].messages, key::kRepeatedSlices));
    EXPECT_EQ(*split.stacks[1].frames[0].instance->instanceNumber, 21);
}

// Half of the positions twice, and nothing says why: that is a question, and no guess.
TEST(Split, ManyRepeatedSlicesAreAQuestion) {
    Frames made;
    for (int k = 0; k < 10; ++k) made.add(2.0 * k);
    for (int k = 0; k < 5; ++k) made.add(2.0 * k);
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 1u) << keys(split);
    EXPECT_EQ(split.stacks[0].whyNoVolume()->key, key::kDuplicatePositions);
    EXPECT_NE(split.stacks[0].whyNoVolume()->action.english().find('?'), std::string::npos);
}

TEST(Split, AnIncompleteLastPhaseSpoilsNoneOfTheOthers) {
    Frames made;
    for (int phase = 1; phase <= 5; ++phase) {
        for (int k = 0; k < (phase == 5 ? 2 : 8); ++k) {
            made.add(2.0 * k);
            made.set("TemporalPositionIndex", std::to_string(phase));
        }
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 5u) << keys(split);
    for (int phase = 0; phase < 4; ++phase)
        EXPECT_TRUE(split.stacks[static_cast<std::size_t>(phase)].isEven());
}

TEST(Split, ChestAndPelvisInOneSeries) {
    Frames made;
    for (int k = 0; k < 12; ++k) made.add(2.0 * k);
    for (int k = 0; k < 10; ++k) made.add(400.9 + 2.0 * k);
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 2u) << keys(split);
    EXPECT_TRUE(split.stacks[0].isEven() && split.stacks[1].isEven());
    EXPECT_TRUE(has(split.messages, key::kSeparateBlocks));
}

TEST(Split, WhatDiffersInKindIsNeverInOneStack) {
    struct Case {
        const char* attribute;
        const char* value;
    };
    for (const Case c : {Case{"Rows", "32"}, Case{"SamplesPerPixel", "3"}, Case{"FrameOfReferenceUID", "9.9"},
                         Case{"SOPClassUID", "1.2.840.10008.5.1.4.1.1.7"}, Case{"Localizer", "yes"},
                         Case{"ImageOrientationPatient", "0\\1\\0\\0\\0\\-1"},
                         Case{"PixelSpacing", "0.9\\0.9"}, Case{"StackID", "2"}, Case{"Modality", "SR"}}) {
        SCOPED_TRACE(c.attribute);
        Frames made;
        for (int k = 0; k < 10; ++k) made.add(2.0 * k);
        made.add(20.5);
        made.set(c.attribute, c.value);
        if (std::string_view(c.attribute) == "ImageOrientationPatient")
            made.frames.back().plane->columnDirection = {0, 0, -1};
        const Split split = splitOf(made);
        ASSERT_EQ(split.stacks.size(), 2u) << keys(split);
        EXPECT_FALSE(split.messages.empty());
        EXPECT_EQ(split.stacks[0].frames.size() + split.stacks[1].frames.size(), 11u);
        EXPECT_EQ(std::min(split.stacks[0].frames.size(), split.stacks[1].frames.size()), 1u);
    }
}

TEST(Split, OrientationsWithinTheNoiseOfDecimalsAreOne) {
    Frames made;
    for (int k = 0; k < 10; ++k) {
        made.add(2.0 * k);
        made.set("ImageOrientationPatient",
                 k % 2 ? "1\\0\\0\\0\\1\\0" : "0.99999\\0.00002\\0\\0\\1\\-0.00003");
    }
    EXPECT_EQ(splitOf(made).stacks.size(), 1u);
}

TEST(Split, ARotationOfProjectionsIsOneStackAndNoVolume) {
    Frames made;
    for (int k = 0; k < 24; ++k) {
        Frame& frame = made.add(0.0);
        const double angle = 0.13 * k;
        frame.plane->rowDirection = {std::cos(angle), std::sin(angle), 0};
        frame.plane->columnDirection = {0, 0, -1};
        made.set("ImageOrientationPatient",
                 std::to_string(std::cos(angle)) + "\\" + std::to_string(std::sin(angle)) + "\\0\\0\\0\\-1");
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 1u) << keys(split);
    EXPECT_EQ(split.stacks[0].whyNoVolume()->key, key::kNotParallel);
}

TEST(Split, SameIdentifierInFilesThatDiffer) {
    Frames made;
    for (int k = 0; k < 8; ++k) made.add(2.0 * k);
    for (int k = 0; k < 8; ++k) {
        made.add(2.0 * k);
        made.instance().sopInstanceUid = "1.2." + std::to_string(k + 1);
    }
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 2u) << keys(split);
    EXPECT_TRUE(has(split.messages, key::kDuplicateInstances));
    EXPECT_TRUE(split.stacks[0].isEven());
    EXPECT_EQ(split.stacks[1].splitBy, (std::vector<StackLabel>{{"Copy", "2"}}));
}

TEST(Split, NothingAndOneFrame) {
    EXPECT_TRUE(splitSeries({}, "CT", splitRules()).stacks.empty());
    Frames made;
    made.add(1.0);
    const Split split = splitOf(made);
    ASSERT_EQ(split.stacks.size(), 1u);
    EXPECT_EQ(split.stacks[0].whyNoVolume()->key, key::kSingleSlice);
}

// Numbers as text, with the padding and signs of real files.
TEST(Split, ValuesOfAttributes) {
    const Attribute number{
        .name = "n", .tags = {}, .kind = Attribute::Kind::number, .relativeTolerance = 1e-4};
    EXPECT_TRUE(sameValue(number, "4.60", "4.6 "));
    EXPECT_TRUE(sameValue(number, "+30", "30.001"));
    EXPECT_FALSE(sameValue(number, "30", "30.1"));
    EXPECT_FALSE(sameValue(number, "", "0"));
    EXPECT_FALSE(sameValue(number, "nan", "0"));
    EXPECT_EQ(numberOf(" 12.5\\99 "), 12.5);
    EXPECT_EQ(numberOf("inf"), std::nullopt);
    EXPECT_EQ(numberOf("12a"), std::nullopt);
}

// A thousand phases of a thousand slices would be a million frames; this many still takes no time to speak
// of.
TEST(Split, ManyFramesOfManyPhases) {
    Frames made;
    for (int phase = 0; phase < 60; ++phase) {
        for (int k = 0; k < 60; ++k) {
            made.add(2.0 * k);
            made.set("TriggerTime", std::to_string(20 * phase));
            made.set("ContentTime", std::to_string(100000 + 60 * phase + k));
        }
    }
    const Split split = splitSeries(made.frames, "MR", splitRules());
    EXPECT_EQ(split.stacks.size(), 60u) << keys(split);
}

}  // namespace
}  // namespace macula::dicom
