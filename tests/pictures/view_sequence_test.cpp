// Sequences of pictures: all of them, or none; and what is laid over them.
#include "pictures/view_sequence.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

#include "base/phantom.h"
#include "gpu/gpu_test.h"
#include "image/image_file.h"
#include "scene/choice/catalogue.h"
#include "support.h"

namespace macula::pictures {
namespace {

namespace fs = std::filesystem;

class ViewSequenceTest : public gpu::GpuTest {
  protected:
    ViewSequence wanted(int frames) const {
        const scene::Catalogue catalogue = *scene::builtInCatalogue();
        ViewSequence sequence;
        ViewPicture& picture = sequence.picture;
        picture.volume = std::make_shared<const Volume>(
            phantom::make({.size = {32, 28, 20}, .spacingMm = {9.6, 9.6, 15.0}}));
        picture.seriesDigest = "phantom";
        picture.drawing.transferFunction = scene::presetFor(catalogue, *picture.volume);
        picture.drawing.lights = scene::defaultLights(catalogue, trace::Look::cinematic);
        picture.sizePx = {24, 18};
        picture.effort.quality = "draft";
        sequence.path = scene::turntable(
            frameBox(picture.volume->worldBox(), ViewDirection::anterior, 30.0, 24.0 / 18.0), 4.0, 4.0);
        sequence.frames = frames;
        sequence.isClosed = true;
        sequence.folder = folder_.path() / "movie";
        return sequence;
    }
    static Result<WrittenSequence> writeIt(const ViewSequence& sequence) {
        Progress progress;
        return writeViewSequence(sequence, {}, progress);
    }
    static std::ptrdiff_t filesIn(const fs::path& folder) {
        std::error_code error;
        return std::distance(fs::directory_iterator(folder, error), fs::directory_iterator());
    }

    const dicom::test::TemporaryFolder folder_;
};

TEST_F(ViewSequenceTest, EachPictureIsFromItsPlace) {
    ViewSequence sequence = wanted(4);
    std::vector<Camera> seen;
    sequence.stampsFor = [&](const Camera& from) {
        seen.push_back(from);
        return std::vector<Stamp>{
            {.atPx = {22, -1}, .sizePx = {4, 3}, .rgba = std::vector<std::uint8_t>(48, 255)}};
    };
    const auto written = writeIt(sequence);
    ASSERT_TRUE(written.ok()) << written.error().message;
    ASSERT_EQ(written->files.size(), 4u);
    EXPECT_EQ(written->files.front().filename(), "frame-0001.png");
    EXPECT_EQ(filesIn(sequence.folder), 4);
    ASSERT_EQ(seen.size(), 4u);
    // Quarter by quarter, towards the patient's left; the last is not the first again.
    EXPECT_LT(seen[0].positionMm.y, -100.0);
    EXPECT_GT(seen[1].positionMm.x, 100.0);
    EXPECT_GT(seen[2].positionMm.y, 100.0);
    EXPECT_LT(seen[3].positionMm.x, -100.0);
    const auto image = image::readImage(written->files.front());
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->width, 24);
    EXPECT_EQ(image->height, 18);
}

TEST_F(ViewSequenceTest, WhoStopsItGetsNone) {
    ViewSequence sequence = wanted(3);
    Progress progress;
    sequence.stampsFor = [&](const Camera&) {
        progress.token().cancel();  // after the first picture was drawn
        return std::vector<Stamp>();
    };
    const auto done = writeViewSequence(sequence, {}, progress);
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().code, ErrorCode::cancelled);
    EXPECT_FALSE(fs::exists(sequence.folder));
}

TEST_F(ViewSequenceTest, WhatIsThereStays) {
    ViewSequence sequence = wanted(1);
    fs::create_directories(sequence.folder);
    std::ofstream(sequence.folder / "frame-0007.png") << "another";
    EXPECT_EQ(writeIt(sequence).error().code, ErrorCode::usage);
    EXPECT_EQ(filesIn(sequence.folder), 1);
    sequence.folder = folder_.path() / "file";
    std::ofstream(sequence.folder) << "no folder";
    EXPECT_EQ(writeIt(sequence).error().code, ErrorCode::outputNotWritable);
    EXPECT_TRUE(fs::is_regular_file(sequence.folder));
}

TEST_F(ViewSequenceTest, WhatCannotBeDrawnIsSaidFirst) {
    for (const int frames : {0, -1, kMostFrames + 1})
        EXPECT_EQ(writeIt(wanted(frames)).error().code, ErrorCode::usage);
    ViewSequence sequence = wanted(1);
    sequence.path.stops.clear();
    EXPECT_EQ(writeIt(sequence).error().code, ErrorCode::usage);
    sequence = wanted(1);
    sequence.picture.sizePx = {0, 4};
    EXPECT_EQ(writeIt(sequence).error().code, ErrorCode::usage);
    EXPECT_FALSE(fs::exists(sequence.folder));
}

TEST(FrameName, HasDigitsForAll) {
    EXPECT_EQ(frameName(0, 1), "frame-0001.png");
    EXPECT_EQ(frameName(9999, 10000), "frame-10000.png");
    EXPECT_EQ(frameName(0, 10000), "frame-00001.png");
}

TEST(CameraOfSequence, EndsAreMetUnlessItIsClosed) {
    ViewSequence sequence;
    Camera camera;
    camera.positionMm = {0.0, -500.0, 0.0};
    sequence.path = scene::turntable(camera, 8.0, 4.0);
    sequence.frames = 5;
    EXPECT_EQ(cameraOf(sequence, 0), sequence.path.stops.front().camera);
    EXPECT_EQ(cameraOf(sequence, 4), sequence.path.stops.back().camera);
    sequence.isClosed = true;
    EXPECT_NE(cameraOf(sequence, 4), sequence.path.stops.back().camera);
    sequence.frames = 1;
    sequence.isClosed = false;
    EXPECT_EQ(cameraOf(sequence, 0), sequence.path.stops.front().camera);
}

TEST(Stamps, LieWhereTheyAreAndNoWhereElse) {
    std::vector<std::uint8_t> picture(4 * 3 * 4, 0);
    putOver(picture, {4, 3}, {.atPx = {2, 1}, .sizePx = {3, 1}, .rgba = std::vector<std::uint8_t>(12, 9)});
    int changed = 0;
    for (const std::uint8_t value : picture) changed += value == 9 ? 1 : 0;
    EXPECT_EQ(changed, 8) << "two of its pixels are in the picture";
    EXPECT_EQ(picture[4 * (4 + 2)], 9);
    const auto before = picture;
    putOver(picture, {4, 3}, {.atPx = {-5, 0}, .sizePx = {3, 1}, .rgba = std::vector<std::uint8_t>(12, 1)});
    putOver(picture, {4, 3}, {.atPx = {0, 7}, .sizePx = {3, 1}, .rgba = std::vector<std::uint8_t>(12, 1)});
    putOver(picture, {4, 3}, {});
    EXPECT_EQ(picture, before);
}

}  // namespace
}  // namespace macula::pictures
