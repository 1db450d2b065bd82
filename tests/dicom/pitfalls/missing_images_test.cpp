// D27: slices that are missing at the ends, where positions are even and show nothing.
#include <dcmtk/dcmdata/dctk.h>

#include <functional>

#include "opened.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

constexpr int kSlices = 24;

class D27MissingImages : public Pitfall {
  protected:
    // Axial, numbered from 1 at the feet, 2 mm apart.
    D27MissingImages() {
        series.worldFromVoxel = glm::dmat4(1.0);
        series.worldFromVoxel[2] = {0, 0, 2, 0};
        series.size = {8, 7, kSlices};
        series.shuffleNumbers = false;
        series.number = 3;
    }

    using Change = std::function<void(std::vector<Slice>&)>;

    static void write(const fs::path& to, const SyntheticSeries& what, const Change& change = {}) {
        std::vector<Slice> slices = slicesOf(what);
        if (change) change(slices);
        writeFiles(to, what, slices);
    }

    static void dropFirst(std::vector<Slice>& slices, int count) {
        slices.erase(slices.begin(), slices.begin() + count);
    }
    static void dropLast(std::vector<Slice>& slices, int count) {
        slices.erase(slices.end() - count, slices.end());
    }

    static Edit says(const DcmTagKey& tag, int count) {
        return [tag, count](DcmItem& item) { put(item, tag, std::to_string(count)); };
    }

    static std::string textOf(const Message& message, std::string_view name) {
        for (const TextArgument& argument : message.arguments) {
            const auto* text = std::get_if<Text>(&argument.value);
            if (argument.name == name && text != nullptr) return text->english();
        }
        return "no text " + std::string(name);
    }

    // The one stack is a volume that goes with this warning.
    static void expectMissing(const Opened& opened, int count, const std::string& side,
                              Severity severity = Severity::warning) {
        ASSERT_EQ(opened.volumes().size(), 1u) << opened.keys();
        const Stack& stack = *opened.volumes()[0];
        const auto told = std::ranges::find(stack.messages, key::kMissingAtEnds, &Message::key);
        ASSERT_NE(told, stack.messages.end()) << opened.keys();
        EXPECT_EQ(numberArgument(*told, "count"), count) << told->sentence;
        EXPECT_EQ(textOf(*told, "side"), side) << told->sentence;
        EXPECT_EQ(told->severity, severity) << told->sentence;
        const bool isAssumed =
            std::ranges::find(stack.assumptions, told->sentence) != stack.assumptions.end();
        EXPECT_EQ(isAssumed, severity == Severity::warning) << "the volume carries it";
    }

    static void expectNothing(const Opened& opened) {
        EXPECT_EQ(opened.volumes().size(), opened.stacks().size()) << opened.keys();
        for (const std::string_view key :
             {key::kMissingAtEnds, key::kMissingImages, key::kOthersReachFarther, key::kStudyIncomplete})
            EXPECT_FALSE(opened.says(key)) << opened.find(key)->sentence;
    }
};

TEST_F(D27MissingImages, NumbersThatBeginLateAreTold) {
    write(folder.path(), series, [](auto& slices) { dropFirst(slices, 7); });
    const Opened opened = open();
    expectMissing(opened, 7, "feet");
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->size().z, kSlices - 7) << "the slices that are there are shown";
    const auto& assumptions = volume->provenance().assumptions;
    EXPECT_NE(std::ranges::find_if(assumptions,
                                   [](const Text& text) {
                                       return text.english().find(
                                                  "towards the feet: 7; the image numbers begin at 8") !=
                                              std::string::npos;
                                   }),
              assumptions.end());
}

TEST_F(D27MissingImages, NumbersMayRunTheOtherWay) {
    write(folder.path(), series, [](auto& slices) {
        for (Slice& slice : slices) slice.instanceNumber = kSlices - slice.place;
        dropLast(slices, 5);
    });
    expectMissing(open(), 5, "head");
}

TEST_F(D27MissingImages, ACopyThatStoppedFallsShortOfTheAcquisition) {
    series.edits.push_back(says(DCM_ImagesInAcquisition, kSlices));
    write(folder.path(), series, [](auto& slices) { dropLast(slices, 5); });
    expectMissing(open(), 5, "head");
}

TEST_F(D27MissingImages, TheSeriesSaysHowManyItHas) {
    series.edits.push_back(says(DCM_NumberOfSeriesRelatedInstances, kSlices));
    write(folder.path(), series, [](auto& slices) {
        dropLast(slices, 4);
        dropFirst(slices, 3);
    });
    const Opened opened = open();
    ASSERT_EQ(opened.volumes().size(), 1u);
    std::map<std::string, double> told;
    for (const Message& message : opened.volumes()[0]->messages) {
        if (message.key == key::kMissingAtEnds)
            told[textOf(message, "side")] = numberArgument(message, "count");
    }
    EXPECT_EQ(told, (std::map<std::string, double>{{"feet", 3.0}, {"head", 4.0}}));
}

TEST_F(D27MissingImages, AVolumeOfPetSaysHowManySlicesItHas) {
    series.modality = "PT";
    series.edits.push_back([](DcmItem& item) { putWord(item, DCM_NumberOfSlices, kSlices); });
    write(folder.path(), series, [](auto& slices) { dropLast(slices, 6); });
    expectMissing(open(), 6, "head");
}

// What is missing between slices is told as that, and not again.
TEST_F(D27MissingImages, GapsAreNoMissingEnds) {
    series.edits.push_back(says(DCM_NumberOfSeriesRelatedInstances, kSlices));
    write(folder.path(), series, [](auto& slices) { slices.erase(slices.begin() + 9, slices.begin() + 11); });
    const Opened opened = open();
    expectNothing(opened);
    EXPECT_TRUE(opened.says(key::kMissingSlices)) << opened.keys();
}

TEST_F(D27MissingImages, WithoutAnOrderOfNumbersNoEndIsNamed) {
    series.shuffleNumbers = true;
    series.edits.push_back(says(DCM_NumberOfSeriesRelatedInstances, kSlices));
    write(folder.path(), series, [](auto& slices) { dropLast(slices, 5); });
    const Opened opened = open();
    const Message* told = opened.find(key::kMissingImages);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_EQ(numberArgument(*told, "count"), 5.0);
    EXPECT_EQ(opened.series().at(0)->assumptions, std::vector<Text>{told->sentence});
    EXPECT_FALSE(opened.says(key::kMissingAtEnds)) << opened.keys();
}

// The records are under a series, as those of every real medium.
TEST_F(D27MissingImages, AMediumListsMoreImagesOfTheSeries) {
    const auto slices = slicesOf(series);
    std::vector<DirectoryEntry> entries;
    for (const Slice& slice : slices) {
        entries.push_back({.fileId = "IMAGES\\" + slice.fileName,
                           .sopInstanceUid = slice.sopInstanceUid,
                           .seriesUid = series.seriesUid,
                           .instanceNumber = slice.instanceNumber});
    }
    writeDirectoryOf(folder / "DICOMDIR", entries);
    write(folder / "IMAGES", series, [](auto& kept) { dropLast(kept, 8); });
    const Opened opened = open();
    EXPECT_TRUE(opened.says(key::kDicomdirMissingFiles)) << opened.keys();
    expectMissing(opened, 8, "head");
    EXPECT_NE(opened.find(key::kMissingAtEnds)->sentence.english().find("DICOMDIR"), std::string::npos);
}

// The same files under other names are all there.
TEST_F(D27MissingImages, FilesOfAMediumMayHaveOtherNames) {
    std::vector<DirectoryEntry> entries;
    for (const Slice& slice : slicesOf(series))
        entries.push_back({"DISC\\D" + std::to_string(slice.place), slice.sopInstanceUid, series.seriesUid,
                           slice.instanceNumber});
    writeDirectoryOf(folder / "DICOMDIR", entries);
    write(folder.path(), series);
    const Opened opened = open();
    expectNothing(opened);
    EXPECT_FALSE(opened.says(key::kDicomdirMissingFiles)) << opened.keys();
}

// Each of these is a way of numbering, and nothing is missing.
TEST_F(D27MissingImages, OtherNumberingsAreNoLoss) {
    const std::vector<std::pair<std::string, std::function<int(const Slice&)>>> numberings{
        {"from 0", [](const Slice& s) { return s.place; }},
        {"from 1001", [](const Slice& s) { return 1001 + s.place; }},
        {"with the number of the series", [](const Slice& s) { return 301 + s.place; }},
        {"thousands of the series", [](const Slice& s) { return 3001 + s.place; }},
        {"from the other end", [](const Slice& s) { return kSlices - s.place; }},
        {"by twos", [](const Slice& s) { return 1 + 2 * s.place; }},
        {"in no order", [](const Slice& s) { return 10 + (s.place ^ 5); }},
        {"as times of a day", [](const Slice& s) { return 93'000'000 + s.place; }},
        {"one for all", [](const Slice&) { return 17; }},
    };
    for (const auto& [name, numberOf] : numberings) {
        SCOPED_TRACE(name);
        const TemporaryFolder own;
        write(own.path(), series, [&](auto& slices) {
            for (Slice& slice : slices) slice.instanceNumber = numberOf(slice);
        });
        expectNothing(Opened(own.path()));
    }
}

// Localizers were 1 and 2 before somebody deleted them: that may be, and so it is a note.
TEST_F(D27MissingImages, TwoNumbersMayHaveBeenThoseOfLocalizers) {
    write(folder.path(), series, [](auto& slices) { dropFirst(slices, 2); });
    expectMissing(open(), 2, "feet", Severity::info);
}

TEST_F(D27MissingImages, LocalizersOfTheSeriesHaveTheNumbersBefore) {
    SyntheticSeries localizer = series;
    localizer.imageType = "ORIGINAL\\PRIMARY\\LOCALIZER";
    localizer.size.z = 3;
    localizer.worldFromVoxel = glm::dmat4(1.0);
    localizer.worldFromVoxel[0] = {0, 1, 0, 0};
    localizer.worldFromVoxel[1] = {0, 0, -1, 0};
    localizer.worldFromVoxel[2] = {-1, 0, 0, 0};
    write(folder.path(), localizer, [](auto& slices) {
        for (Slice& slice : slices) slice.sopInstanceUid += "77";
    });
    write(folder.path(), series, [](auto& slices) {
        for (Slice& slice : slices) slice.instanceNumber += 3;
    });
    const Opened opened = open();
    EXPECT_EQ(opened.volumes().size(), 1u) << opened.keys();
    EXPECT_FALSE(opened.says(key::kMissingAtEnds)) << opened.find(key::kMissingAtEnds)->sentence;
}

// A report or a picture of the screen that was stored in the series has some number of its own.
TEST_F(D27MissingImages, AReportOfTheSeriesMayHaveAnyNumber) {
    write(folder.path(), series);
    SyntheticSeries report = series;
    report.imageType = "DERIVED\\SECONDARY\\SCREEN SAVE";
    report.size = {9, 9, 1};
    write(folder.path(), report, [](auto& slices) {
        slices[0].sopInstanceUid += "99";
        slices[0].instanceNumber = 999;
    });
    const Opened opened = open();
    EXPECT_EQ(opened.volumes().size(), 1u) << opened.keys();
    EXPECT_FALSE(opened.says(key::kMissingAtEnds)) << opened.find(key::kMissingAtEnds)->sentence;
    EXPECT_FALSE(opened.says(key::kMissingImages));
}

TEST_F(D27MissingImages, NumbersMayGoOnFromSeriesToSeries) {
    write(folder.path(), series);
    SyntheticSeries next = series;
    next.seriesUid = "2.25.1777";
    next.number = 4;
    write(folder.path(), next, [](auto& slices) {
        for (Slice& slice : slices) slice.instanceNumber += kSlices;
    });
    expectNothing(open());
}

// Phases that are stored in turns, or one by one: no other has numbers that one lacks.
TEST_F(D27MissingImages, PhasesHaveEachOthersNumbers) {
    for (const bool inTurns : {true, false}) {
        SCOPED_TRACE(inTurns);
        const TemporaryFolder own;
        SyntheticSeries phases = series;
        phases.phases = 3;
        write(own.path(), phases, [&](auto& slices) {
            for (Slice& slice : slices) {
                slice.instanceNumber =
                    inTurns ? 1 + 3 * slice.place + slice.phase : 1 + slice.place + kSlices * slice.phase;
                slice.edits.push_back([phase = slice.phase](DcmItem& item) {
                    put(item, DCM_TemporalPositionIdentifier, std::to_string(phase + 1));
                });
            }
        });
        const Opened opened(own.path());
        EXPECT_EQ(opened.volumes().size(), 3u) << opened.keys();
        expectNothing(opened);
    }
}

TEST_F(D27MissingImages, PhasesThatLackTheirFirstPositionsSayHowMany) {
    series.phases = 3;
    write(folder.path(), series, [&](auto& slices) {
        for (Slice& slice : slices) {
            slice.instanceNumber = 1 + 3 * slice.place + slice.phase;
            slice.edits.push_back([phase = slice.phase](DcmItem& item) {
                put(item, DCM_TemporalPositionIdentifier, std::to_string(phase + 1));
            });
        }
        std::erase_if(slices, [](const Slice& slice) { return slice.place < 4; });
    });
    const Opened opened = open();
    ASSERT_EQ(opened.volumes().size(), 3u) << opened.keys();
    for (const Stack* stack : opened.volumes()) {
        const auto told = std::ranges::find(stack->messages, key::kMissingAtEnds, &Message::key);
        ASSERT_NE(told, stack->messages.end());
        EXPECT_EQ(numberArgument(*told, "count"), 4.0);
        EXPECT_EQ(textOf(*told, "side"), "feet");
    }
}

// Two regions of one series: the numbers between them are of images that neither has.
TEST_F(D27MissingImages, WhatIsMissingBetweenTwoRegionsIsBeyondAnEndOfEach) {
    write(folder.path(), series, [](auto& slices) {
        for (Slice& slice : slices) {
            if (slice.place >= 12) slice.positionMm.z += 300.0;
        }
        slices.erase(slices.begin() + 9, slices.begin() + 12);
    });
    const Opened opened = open();
    ASSERT_EQ(opened.volumes().size(), 2u) << opened.keys();
    std::vector<std::string> sides;
    for (const Stack* stack : opened.volumes()) {
        for (const Message& message : stack->messages) {
            if (message.key != key::kMissingAtEnds) continue;
            EXPECT_EQ(numberArgument(message, "count"), 3.0) << message.sentence;
            sides.push_back(textOf(message, "side"));
        }
    }
    EXPECT_EQ(sides, (std::vector<std::string>{"head", "feet"}));
}

TEST_F(D27MissingImages, ThreeTimesAsManyMayCountOtherSeries) {
    series.edits.push_back(says(DCM_ImagesInAcquisition, 4 * kSlices));
    write(folder.path(), series);
    expectMissing(open(), 3 * kSlices, "head", Severity::info);
}

// Two reconstructions of one acquisition, which counts the images of both.
TEST_F(D27MissingImages, AnAcquisitionMayBeSeveralSeries) {
    series.edits.push_back(says(DCM_ImagesInAcquisition, 2 * kSlices));
    write(folder.path(), series);
    SyntheticSeries second = series;
    second.seriesUid = "2.25.1888";
    second.number = 4;
    write(folder.path(), second);
    expectNothing(open());
}

TEST_F(D27MissingImages, ASeriesBesideItThatReachesFartherIsNoted) {
    write(folder.path(), series);
    SyntheticSeries stopped = series;
    stopped.seriesUid = "2.25.1999";
    stopped.number = 4;
    write(folder.path(), stopped, [](auto& slices) { dropLast(slices, 10); });
    const Opened opened = open();
    const Message* told = opened.find(key::kOthersReachFarther);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_EQ(told->severity, Severity::info);
    EXPECT_NEAR(numberArgument(*told, "mm"), 20.0, 1e-6);
    EXPECT_EQ(textOf(*told, "side"), "head");
    EXPECT_EQ(textOf(*told, "other"), "Series 3");
    std::size_t times = 0;
    for (const Message* message : opened.messages())
        times += message->key == key::kOthersReachFarther ? 1 : 0;
    EXPECT_EQ(times, 1u) << "the longer one lacks nothing";
}

TEST_F(D27MissingImages, ALocalizerThatReachesFarFartherIsNoted) {
    SyntheticSeries localizer = series;
    localizer.imageType = "ORIGINAL\\PRIMARY\\LOCALIZER";
    localizer.seriesUid = "2.25.1555";
    localizer.number = 1;
    localizer.size = {8, 24, 1};
    // Sagittal, 24 rows of 2 mm from the head (46 mm) to the feet (0 mm).
    localizer.worldFromVoxel = glm::dmat4(1.0);
    localizer.worldFromVoxel[0] = {0, 1, 0, 0};
    localizer.worldFromVoxel[1] = {0, 0, -2, 0};
    localizer.worldFromVoxel[2] = {-1, 0, 0, 0};
    localizer.worldFromVoxel[3] = {0, 0, 46, 1};
    write(folder.path(), localizer);
    write(folder.path(), series, [](auto& slices) { dropLast(slices, 11); });
    const Opened opened = open();
    const Message* told = opened.find(key::kOthersReachFarther);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_NEAR(numberArgument(*told, "mm"), 22.0, 1e-6);
    EXPECT_EQ(textOf(*told, "side"), "head");
    EXPECT_EQ(textOf(*told, "other"), "The localizer");
}

TEST_F(D27MissingImages, TheStudySaysHowManyObjectsItHas) {
    series.edits.push_back(says(DCM_NumberOfStudyRelatedInstances, kSlices + 100));
    write(folder.path(), series);
    const Opened opened = open();
    const Message* told = opened.find(key::kStudyIncomplete);
    ASSERT_NE(told, nullptr);
    EXPECT_EQ(numberArgument(*told, "count"), kSlices);
    EXPECT_EQ(numberArgument(*told, "total"), kSlices + 100);
    EXPECT_EQ(told->severity, Severity::info);
}

TEST_F(D27MissingImages, MultiFrameFilesHaveNumbersOfFiles) {
    std::vector<Slice> slices = slicesOf(series);
    for (Slice& slice : slices) slice.instanceNumber = 9;
    writeMultiFrame(folder / "enhanced", series, slices);
    expectNothing(open());
}

}  // namespace
}  // namespace macula::dicom::test
