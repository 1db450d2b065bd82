// Presentation states of grey slices: what is in them is read, and no file, however damaged, makes anything
// but a sentence.
#include "dicom/presentation/softcopy_state.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <fstream>

#include "dicom/scan.h"
#include "support.h"
#include "synthetic_softcopy.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

class SoftcopyStateTest : public testing::Test {
  protected:
    SoftcopyStateTest() { said_.imageUids = {"2.25.8", "2.25.7"}; }

    SoftcopyState read() {
        writeSoftcopy(path_, said_);
        const auto state = readSoftcopyState(path_);
        EXPECT_TRUE(state.ok()) << (state ? "" : state.error().message.english());
        return state ? *state : SoftcopyState{};
    }
    Error refused() {
        const auto state = readSoftcopyState(path_);
        EXPECT_FALSE(state.ok());
        return state ? Error{} : state.error();
    }

    const TemporaryFolder folder_;
    const fs::path path_ = folder_ / "state.dcm";
    SyntheticSoftcopy said_;
};

TEST_F(SoftcopyStateTest, WhatIsSaidIsRead) {
    said_.area = {3, 2, 6, 5};
    said_.isInverse = true;
    const SoftcopyState state = read();
    EXPECT_EQ(state.seriesUids, std::vector<std::string>{"2.25.1001"});
    EXPECT_EQ(state.images,
              (std::vector<ReferencedFrames>{{.sopInstanceUid = "2.25.8"}, {.sopInstanceUid = "2.25.7"}}));
    EXPECT_EQ(state.slope, 1.0);
    EXPECT_EQ(state.intercept, -1024.0);
    ASSERT_EQ(state.windows.size(), 1u);
    ASSERT_TRUE(state.windows[0].window);
    EXPECT_EQ(state.windows[0].window->center, -600.0);
    EXPECT_EQ(state.windows[0].window->width, 1500.0);
    ASSERT_EQ(state.areas.size(), 1u);
    EXPECT_EQ(state.areas[0].topLeft, glm::ivec2(3, 2));
    EXPECT_EQ(state.areas[0].bottomRight, glm::ivec2(6, 5));
    EXPECT_EQ(state.areas[0].size, DisplayedSize::fitted);
    EXPECT_TRUE(state.isInverse);
    EXPECT_FALSE(state.isFlipped);
    EXPECT_EQ(state.rotationDeg, 0);
    EXPECT_FALSE(state.hasModalityTable);
    EXPECT_TRUE(state.leftOut.empty());
}

TEST_F(SoftcopyStateTest, WhatCannotBeShownIsTold) {
    said_.isFlipped = true;
    said_.rotationDeg = 90;
    said_.edits.push_back([](DcmItem& item) {
        nested(item, DCM_GraphicAnnotationSequence);
        put(item, DCM_ShutterShape, "CIRCULAR");
        nested(item, DCM_ModalityLUTSequence);
    });
    const SoftcopyState state = read();
    EXPECT_TRUE(state.isFlipped);
    EXPECT_EQ(state.rotationDeg, 90);
    EXPECT_TRUE(state.hasModalityTable);
    EXPECT_EQ(state.leftOut, (std::vector<Text>{Text("annotations"), Text("a shutter")}));
}

// Corners the other way round would mirror the image; a window of no width shows nothing.
TEST_F(SoftcopyStateTest, NonsenseIsNoAreaAndNoWindow) {
    said_.area = {6, 2, 3, 5};
    said_.window = std::pair(40.0, 0.0);
    const SoftcopyState state = read();
    EXPECT_TRUE(state.areas.empty());
    EXPECT_EQ(state.leftOut, std::vector<Text>{Text("a displayed area that is none")});
    EXPECT_TRUE(state.windows.empty());
}

TEST_F(SoftcopyStateTest, WhatIsNoneIsAnErrorThatSaysSo) {
    EXPECT_EQ(refused().code, ErrorCode::inputNotUsable) << "there is no file";
    EXPECT_EQ(refused().message, "The file cannot be read.");
    std::ofstream(folder_ / "letter.dcm") << "a letter to somebody, and no presentation state at all";
    const auto letter = readSoftcopyState(folder_ / "letter.dcm");
    ASSERT_FALSE(letter.ok());
    EXPECT_NE(letter.error().message.english().find("not a DICOM presentation state"), std::string::npos);
    write(smallVolume(), folder_ / "images");
    const auto image = readSoftcopyState(*fs::directory_iterator(folder_ / "images"));
    ASSERT_FALSE(image.ok());
    EXPECT_NE(image.error().message.english().find("no presentation state"), std::string::npos);
    said_.imageUids.clear();
    writeSoftcopy(path_, said_);
    EXPECT_NE(refused().message.english().find("which images"), std::string::npos);
}

// Numbers that are none mean all frames, which is told.
TEST_F(SoftcopyStateTest, FramesOfAnImageAreReadAsTheyAreNamed) {
    said_.imageUids = {"2.25.8"};
    said_.frames = "3\\1\\3";
    EXPECT_EQ(read().images,
              (std::vector<ReferencedFrames>{{.sopInstanceUid = "2.25.8", .numbers = {3, 1, 3}}}));
    EXPECT_TRUE(read().leftOut.empty());
    for (const char* none : {"0", "-2", "2\\x", "1.5", "99999999999"}) {
        said_.frames = none;
        const SoftcopyState state = read();
        ASSERT_EQ(state.images.size(), 1u);
        EXPECT_TRUE(state.images[0].numbers.empty()) << none;
        EXPECT_EQ(state.leftOut, std::vector<Text>{Text("an unreadable list of frames")}) << none;
    }
}

TEST_F(SoftcopyStateTest, ImagesThatAreNamedTwiceAreOneWithTheFramesOfBoth) {
    const std::vector<ReferencedFrames> images = byImage({{.sopInstanceUid = "2", .numbers = {5, 1}},
                                                          {.sopInstanceUid = "1"},
                                                          {.sopInstanceUid = "2", .numbers = {1, 3}},
                                                          {.sopInstanceUid = "1", .numbers = {4}}});
    EXPECT_EQ(images, (std::vector<ReferencedFrames>{{.sopInstanceUid = "1"},
                                                     {.sopInstanceUid = "2", .numbers = {1, 3, 5}}}));
    EXPECT_TRUE(images[1].holds(2));
    EXPECT_FALSE(images[1].holds(3)) << "frames of a file count from 0, those of an object from 1";
}

TEST_F(SoftcopyStateTest, TheSizeOnTheScreenIsRead) {
    said_.area = {3, 2, 6, 5};
    said_.sizeMode = "TRUE SIZE";
    EXPECT_EQ(read().areas.at(0).size, DisplayedSize::trueSize);
    said_.sizeMode = "MAGNIFY";
    EXPECT_EQ(read().areas.at(0).size, DisplayedSize::magnified);
    said_.sizeMode = "";
    EXPECT_EQ(read().areas.at(0).size, DisplayedSize::fitted);
}

TEST_F(SoftcopyStateTest, CutOffAnywhereItIsReadOrRefused) {
    said_.area = {3, 2, 6, 5};
    writeSoftcopy(path_, said_);
    std::ifstream stream(path_, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
    ASSERT_GT(bytes.size(), 200u);
    for (std::size_t length = 0; length < bytes.size(); length += 7) {
        std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes.substr(0, length);
        const auto state = readSoftcopyState(path_);
        if (!state) {
            EXPECT_FALSE(state.error().message.empty());
            EXPECT_EQ(state.error().message.english().find("SYNTHETIC"), std::string::npos);
        }
    }
}

TEST_F(SoftcopyStateTest, TheScanKnowsWhatItIsOfAndWhatItCallsItself) {
    writeSoftcopy(path_, said_);
    const auto scanned = scan(folder_.path());
    ASSERT_TRUE(scanned);
    ASSERT_EQ(scanned->studies.size(), 1u);
    ASSERT_EQ(scanned->studies[0].series.size(), 1u);
    const Series& series = scanned->studies[0].series[0];
    ASSERT_EQ(series.objects.size(), 1u);
    const OtherObject& object = series.objects[0];
    EXPECT_EQ(object.referencedSeriesUids, std::vector<std::string>{"2.25.1001"});
    EXPECT_EQ(object.label, "Seen by night");
    ASSERT_TRUE(object.presentation);
    EXPECT_EQ(*object.presentation,
              (PresentationHeading{"LUNG",
                                   "Seen by night",
                                   "20240229",
                                   "101112",
                                   "Reader^Night",
                                   {{.sopInstanceUid = "2.25.7"}, {.sopInstanceUid = "2.25.8"}}}));
    EXPECT_TRUE(hasMessage(series, key::kPresentationState));
    EXPECT_FALSE(hasMessage(series, key::kUnsupportedSopClass));
}

}  // namespace
}  // namespace macula::dicom::test
