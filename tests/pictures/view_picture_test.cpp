// What a window shows, as files: PNG, EXR and DICOM, and nothing where it cannot be.
#include "pictures/view_picture.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "base/phantom.h"
#include "gpu/gpu_test.h"
#include "pictures/drawn_picture.h"
#include "scene/choice/catalogue.h"
#include "support.h"

namespace macula::pictures {
namespace {

namespace fs = std::filesystem;

class ViewPictureTest : public gpu::GpuTest {
  protected:
    ViewPicture wanted(const std::string& name) const {
        const scene::Catalogue catalogue = *scene::builtInCatalogue();
        ViewPicture picture{.volume = std::make_shared<const Volume>(
                                phantom::make({.size = {48, 42, 30}, .spacingMm = {6.4, 6.4, 10.0}})),
                            .seriesDigest = "phantom",
                            .sizePx = {31, 17},
                            .effort = {.quality = "draft"},
                            .output = folder_.path() / name,
                            .isOfNobody = true};
        picture.drawing = {.transferFunction = scene::presetFor(catalogue, *picture.volume),
                           .lights = scene::defaultLights(catalogue, trace::Look::cinematic),
                           .clip = nullptr};
        picture.camera = frameBox(picture.volume->worldBox(), ViewDirection::anterior, 30.0, 31.0 / 17.0);
        return picture;
    }
    static Result<std::vector<Text>> writeIt(const ViewPicture& picture) {
        Progress progress;
        return writeViewPicture(picture, {}, progress);
    }

    const dicom::test::TemporaryFolder folder_;
};

TEST_F(ViewPictureTest, EachKindOfFileIsWritten) {
    for (const auto& [name, begins, at] : {std::tuple("a.png", std::string("\x89PNG"), 0),
                                           std::tuple("a.exr", std::string("\x76\x2f\x31\x01"), 0),
                                           std::tuple("a.DCM", std::string("DICM"), 128)}) {
        const auto done = writeIt(wanted(name));
        ASSERT_TRUE(done.ok()) << name << ": " << (done ? "" : done.error().message.english());
        const std::string bytes = *readText(folder_.path() / name);
        EXPECT_EQ(bytes.substr(std::size_t(at), begins.size()), begins) << name;
    }
}

// Who finds the image in an archive reads that a part of it is blurred or faded on purpose.
TEST_F(ViewPictureTest, AnImageTellsOfItsLensAndFog) {
    ViewPicture picture = wanted("a.dcm");
    ASSERT_TRUE(writeIt(picture).ok());
    EXPECT_EQ(readText(picture.output)->find("lens"), std::string::npos);
    picture.effects = {.lensMm = 20.0, .focusMm = 512.0, .fogMm = 75.0};
    ASSERT_TRUE(writeIt(picture).ok());
    const std::string bytes = *readText(picture.output);
    EXPECT_NE(bytes.find("blurred by a lens of 20 mm but at 512 mm, faded by fog of 75 mm"),
              std::string::npos);

    picture = wanted("none.png");
    picture.effects.fogMm = -1.0;
    const auto refused = writeIt(picture);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::usage);
    EXPECT_FALSE(fs::exists(picture.output));
}

// Over what is displayed, also in DICOM; and no one asks where there is light alone.
TEST_F(ViewPictureTest, OverlaysLieOverPicturesAndNotOverLight) {
    ASSERT_TRUE(writeIt(wanted("clean.png")).ok());
    for (const char* name : {"a.png", "a.dcm", "a.exr"}) {
        ViewPicture picture = wanted(name);
        int asked = 0;
        picture.stampsFor = [&](const Camera& camera) {
            ++asked;
            EXPECT_EQ(camera, picture.camera);
            return std::vector<Stamp>{
                {.atPx = {3, 4}, .sizePx = {5, 6}, .rgba = std::vector<std::uint8_t>(5 * 6 * 4, 200)}};
        };
        const auto done = writeIt(picture);
        ASSERT_TRUE(done.ok()) << name;
        const bool isLight = std::string(name) == "a.exr";
        EXPECT_EQ(asked, isLight ? 0 : 1) << name;
        const bool isTold = std::any_of(done->begin(), done->end(), [](const Text& sentence) {
            return sentence.english().find("no cube") != std::string::npos;
        });
        EXPECT_EQ(isTold, isLight) << name;
    }
    EXPECT_NE(*readText(folder_.path() / "a.png"), *readText(folder_.path() / "clean.png"));
    const std::string capture = *readText(folder_.path() / "a.dcm");
    EXPECT_NE(capture.find("with marks of orientation and scale"), std::string::npos);
    EXPECT_NE(capture.find(std::string(15, char(200))), std::string::npos) << "they are in the pixels";
}

TEST_F(ViewPictureTest, WhatCannotBeWrittenIsSaidBeforeAnythingIsDrawn) {
    const auto refused = [&](const ViewPicture& picture) {
        const auto done = writeIt(picture);
        ASSERT_FALSE(done.ok());
        EXPECT_EQ(done.error().code, ErrorCode::usage);
        EXPECT_FALSE(fs::exists(picture.output));
    };
    refused(wanted("a.jpg"));
    ViewPicture none = wanted("a.png");
    none.sizePx = {0, 10};
    refused(none);
    ViewPicture huge = wanted("a.png");
    huge.sizePx = {1 << 20, 10};
    refused(huge);
}

TEST_F(ViewPictureTest, WhatWasCancelledBeginsNothing) {
    const CancelToken token;
    Progress progress({}, token);
    token.cancel();
    const auto drawn = drawViewPictures({wanted("a.png")}, "no such device", progress);
    ASSERT_FALSE(drawn.ok());
    EXPECT_EQ(drawn.error().code, ErrorCode::cancelled) << drawn.error().message;
}

TEST_F(ViewPictureTest, TwoPresetsAreDrawnBesideEachOtherWithoutAnyFile) {
    const scene::Catalogue catalogue = *scene::builtInCatalogue();
    ViewPicture first = wanted("a.png");
    first.drawing.settings.look = trace::Look::dvr;
    ViewPicture second = first;
    second.drawing.transferFunction = *scene::findPreset(catalogue, "ct-lung");
    second.output.clear();
    Progress progress;
    const auto drawn = drawViewPictures({first, second, first}, {}, progress);
    ASSERT_TRUE(drawn.ok()) << drawn.error().message;
    ASSERT_EQ(drawn->size(), 3u);
    for (const auto& rgba : *drawn) EXPECT_EQ(rgba.size(), std::size_t(31 * 17 * 4));
    EXPECT_NE(drawn->at(0), drawn->at(1));
    EXPECT_EQ(drawn->at(0), drawn->at(2));
    EXPECT_FALSE(fs::exists(first.output));
    Progress stopped;
    stopped.token().cancel();
    EXPECT_EQ(drawViewPictures({first}, {}, stopped).error().code, ErrorCode::cancelled);
}

TEST_F(ViewPictureTest, WhoStopsItGetsNoFile) {
    Progress progress;
    progress.token().cancel();
    const auto done = writeViewPicture(wanted("a.png"), {}, progress);
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().code, ErrorCode::cancelled);
    EXPECT_FALSE(fs::exists(folder_.path() / "a.png"));
}

}  // namespace
}  // namespace macula::pictures
