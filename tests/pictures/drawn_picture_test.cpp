// A small picture of the phantom, and what is told of it.
#include "pictures/drawn_picture.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "base/installation_key.h"
#include "base/phantom.h"
#include "gpu/gpu_test.h"
#include "pictures/fitted_view.h"
#include "pictures/picture_file.h"
#include "pictures/preset_sheet.h"
#include "pictures/render_record.h"
#include "scene/choice/catalogue.h"
#include "scene/choice/lights_choice.h"
#include "scene/choice/preset_choice.h"
#include "support.h"

namespace macula::pictures {
namespace {

class DrawnPictureTest : public gpu::GpuTest {
  protected:
    static PictureRequest request(trace::Look look = trace::Look::cinematic) {
        PictureRequest asked{.scene = {.volume = std::make_shared<const Volume>(phantom::make(
                                           {.size = {48, 42, 30}, .spacingMm = {6.4, 6.4, 10.0}})),
                                       .function = scene::choosePreset("cinematic-bone")->function,
                                       .environment = *scene::chooseLights("studio")},
                             .sizePx = {40, 30},
                             .samplesPerPixel = 2};
        asked.settings.look = look;
        return asked;
    }
    DrawnPicture draw(const PictureRequest& asked) {
        Progress progress;
        return gpu::expectOk(drawPicture(device(), asked, progress));
    }
    // Columns and rows that show something.
    static glm::ivec2 extentOf(const DrawnPicture& picture, const glm::ivec2& size) {
        glm::ivec2 low(size);
        glm::ivec2 high(-1);
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const std::uint8_t* pixel = &picture.rgba[4 * static_cast<std::size_t>(y * size.x + x)];
                if (std::max({pixel[0], pixel[1], pixel[2]}) == 0) continue;
                low = glm::min(low, glm::ivec2(x, y));
                high = glm::max(high, glm::ivec2(x, y));
            }
        }
        return high - low + 1;
    }
};

TEST_F(DrawnPictureTest, EveryPresetAndRigShowsSomething) {
    std::optional<PictureDrawer> kept;
    Progress progress;
    const auto brightness = [&](const PictureRequest& asked) {
        gpu::expectOk(PictureDrawer::adapt(kept, device(), asked, progress));
        const DrawnPicture picture = gpu::expectOk(kept->draw(asked.camera, progress));
        double sum = 0.0;
        for (std::size_t pixel = 0; pixel < picture.rgba.size(); pixel += 4)
            sum += (picture.rgba[pixel] + picture.rgba[pixel + 1] + picture.rgba[pixel + 2]) / 255.0;
        return sum / (3.0 * asked.sizePx.x * asked.sizePx.y);
    };
    const scene::Catalogue all = gpu::expectOk(scene::builtInCatalogue());
    int presets = 0;
    for (const auto& preset : all.presets) {
        if (preset->unit != Unit::hounsfield) continue;  // the phantom is a CT
        // Of 3D Slicer's a few: some paint the skin almost black, and all are compared by their numbers.
        const bool isOne = preset->name == "ct-bone" || preset->name == "ct-lung" || preset->name == "ct-aaa";
        if (!preset->name.starts_with("cinematic-") && !isOne) continue;
        PictureRequest asked = request();
        asked.scene.function = *preset;
        EXPECT_GT(brightness(asked), 0.005) << preset->name;
        ++presets;
    }
    EXPECT_GE(presets, 8);
    for (const auto& lights : all.lights) {
        PictureRequest asked = request();
        asked.scene.environment = gpu::expectOk(scene::chooseLights(lights->name));
        EXPECT_GT(brightness(asked), 0.005) << lights->name;
    }
}

// Whatever changed meanwhile, what stays on the device shows what it would if it were brought there anew.
TEST_F(DrawnPictureTest, OfASceneThatStaysOnTheDeviceIsAsIfItWereDrawnAlone) {
    std::optional<PictureDrawer> kept;
    Progress progress;
    PictureRequest asked = request();
    asked.samplesPerPixel = 9;
    const auto expectSame = [&](const char* what) {
        gpu::expectOk(PictureDrawer::adapt(kept, device(), asked, progress));
        const DrawnPicture again = gpu::expectOk(kept->draw(asked.camera, progress));
        const DrawnPicture alone = draw(asked);
        EXPECT_EQ(again.rgba, alone.rgba) << what;
        EXPECT_EQ(again.camera, alone.camera) << what;
        EXPECT_EQ(again.statistics.samplesPerPixel, alone.statistics.samplesPerPixel) << what;
        return std::pair(again.statistics.voxels.uploadedBlocks, alone.statistics.voxels.uploadedBlocks);
    };
    expectSame("first");
    expectSame("nothing changed");
    asked.scene.function = scene::choosePreset("cinematic-soft-tissue")->function;
    expectSame("preset");
    asked.scene.clip.planes = {{.normal = {1, 0, 0}, .offsetMm = 0.0}};
    const auto [more, all] = expectSame("clip");
    EXPECT_EQ(more, 0u) << "they are there";
    EXPECT_GT(all, 0u);
    asked.scene.environment = *scene::chooseLights("headlight");
    expectSame("lights");
    asked.settings.denoising = trace::Denoising::on;
    expectSame("denoised");
    asked.settings.denoising = trace::Denoising::off;
    for (const trace::Look look : {trace::Look::dvr, trace::Look::mip, trace::Look::cinematic}) {
        asked.settings.look = look;
        expectSame("look");
    }
    asked.memory.voxelBytes = 20'000;
    expectSame("little memory");
    asked.scene.clip.planes.front().offsetMm = 30.0;
    expectSame("another clip in it");
    asked.memory = {};
    expectSame("memory");
    asked.scene.clip = {};
    asked.scene.function = request().scene.function;
    asked.sizePx = {33, 40};
    expectSame("size, and back");
    // So large that one portion of time is enough: where there are several, samples go by what each had time
    // for.
    asked.settings.errorThreshold = 0.3;
    expectSame("noise");
    asked.scene.volume =
        std::make_shared<const Volume>(phantom::make({.size = {40, 42, 30}, .spacingMm = {6.4, 6.4, 10.0}}));
    expectSame("volume");
}

// Twice the light, half the exposure; and the picture is as if that had been asked for.
TEST_F(DrawnPictureTest, MetersItsExposure) {
    PictureRequest asked = request();
    asked.settings.exposure = 40.0;  // whatever it was
    asked.metersExposure = true;
    const DrawnPicture metered = draw(asked);
    EXPECT_GT(metered.exposure, 0.1);
    EXPECT_LT(metered.exposure, 10.0);
    asked.settings.lightStrength = 2.0;
    EXPECT_NEAR(draw(asked).exposure, 0.5 * metered.exposure, 1e-3 * metered.exposure);
    PictureRequest same = request();
    same.settings.exposure = metered.exposure;
    EXPECT_EQ(draw(same).rgba, metered.rgba);
    RenderRecord record;
    record.add(asked, metered);
    EXPECT_EQ(record.settings.exposure, metered.exposure);
    // No exposure changes a grey face: how bright it is does not count.
    asked = request();
    asked.metersExposure = true;
    asked.scene.clip.planes = {{.normal = {0, 1, 0}, .offsetMm = 0.0}};
    asked.scene.clip.greyFaces = DisplayWindow{.center = 0.0, .width = 2000.0};
    const DrawnPicture dim = draw(asked);
    asked.camera = dim.camera;  // the camera would fit what faces show, too
    asked.scene.clip.greyFaces = DisplayWindow{.center = -900.0, .width = 10.0};
    EXPECT_NEAR(draw(asked).exposure, dim.exposure, 0.02 * dim.exposure);
    // A projection is shown through its window.
    asked = request(trace::Look::mip);
    asked.metersExposure = true;
    EXPECT_EQ(draw(asked).exposure, asked.settings.exposure);
}

TEST_F(DrawnPictureTest, WhatIsStoppedKeepsNothing) {
    std::optional<PictureDrawer> kept;
    Progress progress;
    PictureRequest asked = request();
    gpu::expectOk(PictureDrawer::adapt(kept, device(), asked, progress));
    Progress stopping;
    stopping.token().cancel();
    asked.scene.function = scene::choosePreset("cinematic-soft-tissue")->function;
    const auto stopped = PictureDrawer::adapt(kept, device(), asked, stopping);
    ASSERT_FALSE(stopped.ok());
    EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
    EXPECT_FALSE(kept.has_value());
}

// Who has no device, and writes down a view alone, gets the camera that a picture is drawn by.
TEST_F(DrawnPictureTest, TheCameraThatFitsIsTheSameWithoutADevice) {
    for (const trace::Look look : {trace::Look::cinematic, trace::Look::mip}) {
        PictureRequest asked = request(look);
        asked.from = ViewDirection::left;
        asked.scene.clip.planes = {{.normal = {1, 0, 0}, .offsetMm = 0.0}};
        const Volume& volume = *asked.scene.volume;
        const Camera fitted = standingBefore(
            fittedCamera(outlineOnHostMm(volume, asked.scene.function, asked.scene.clip), look, volume,
                         {.from = asked.from,
                          .verticalFovDeg = asked.verticalFovDeg,
                          .aspectWidthOverHeight = 40.0 / 30.0}),
            volume.worldBox());
        const Camera drawn = draw(asked).camera;
        EXPECT_LT(glm::distance(drawn.positionMm, fitted.positionMm), 1e-6) << nameOf(look);
        EXPECT_LT(glm::distance(drawn.targetMm, fitted.targetMm), 1e-6) << nameOf(look);
    }
    // Nothing to be seen: the whole volume.
    const std::shared_ptr<const Volume> volume = request().scene.volume;
    const Camera empty = fittedCamera({}, trace::Look::cinematic, *volume, {.from = ViewDirection::anterior});
    EXPECT_LT(glm::distance(empty.targetMm, volume->worldBox().centre()), 1e-6);
}

// The same request, the same bytes: samples are a function of their number.
TEST_F(DrawnPictureTest, IsAFunctionOfTheRequest) {
    const PictureRequest asked = request();
    const DrawnPicture picture = draw(asked);
    EXPECT_EQ(picture.rgba.size(), 4u * 40u * 30u);
    EXPECT_FALSE(picture.traced);
    EXPECT_FALSE(isEmpty(picture, asked));
    EXPECT_EQ(picture.statistics.samplesPerPixel, 2u);
    EXPECT_TRUE(notesOf(picture, asked).empty());
    EXPECT_EQ(draw(asked).rgba, picture.rgba);
}

TEST_F(DrawnPictureTest, IsFilledByWhatCanBeSeenUnlessACameraIsGiven) {
    PictureRequest asked = request(trace::Look::dvr);
    asked.sizePx = {64, 64};
    const DrawnPicture fitted = draw(asked);
    const glm::ivec2 extent = extentOf(fitted, asked.sizePx);
    EXPECT_NEAR(std::max(extent.x, extent.y), 0.9 * 64, 4.0);
    EXPECT_EQ(fitted.camera.verticalFovDeg, asked.verticalFovDeg);

    asked.camera = fitted.camera;
    EXPECT_EQ(draw(asked).rgba, fitted.rgba);
    asked.camera->positionMm =
        asked.camera->targetMm + 2.0 * (asked.camera->positionMm - asked.camera->targetMm);
    const glm::ivec2 farther = extentOf(draw(asked), asked.sizePx);
    EXPECT_NEAR(std::max(farther.x, farther.y), 0.45 * 64, 4.0);
}

TEST_F(DrawnPictureTest, SaysThatNothingIsSeen) {
    PictureRequest asked = request(trace::Look::dvr);
    asked.camera = Camera{.positionMm = {0.0, -2000.0, 0.0}, .targetMm = {0.0, -4000.0, 0.0}};
    for (const bool isLinear : {false, true}) {
        asked.isLinear = isLinear;
        const DrawnPicture picture = draw(asked);
        EXPECT_EQ(picture.traced.has_value(), isLinear);
        EXPECT_TRUE(isEmpty(picture, asked));
        const std::vector<PictureNote> notes = notesOf(picture, asked);
        ASSERT_EQ(notes.size(), 1u);
        EXPECT_TRUE(notes.front().isWarning);
    }
}

// As it was asked for where nothing is seen, whatever the exposure; what is opaque hides it.
TEST_F(DrawnPictureTest, LiesOverTheBackgroundThatIsAskedFor) {
    PictureRequest asked = request(trace::Look::dvr);
    asked.sizePx = {64, 64};
    const DrawnPicture black = draw(asked);
    asked.background = {250, 60, 3};
    for (const double exposure : {1.0, 4.0}) {
        asked.settings.exposure = exposure;
        const DrawnPicture red = draw(asked);
        const std::vector<std::uint8_t> corner(red.rgba.begin(), red.rgba.begin() + 4);
        EXPECT_EQ(corner, (std::vector<std::uint8_t>{250, 60, 3, 255})) << exposure;
        EXPECT_FALSE(isEmpty(red, asked));
    }
    asked.settings.exposure = 1.0;
    const DrawnPicture red = draw(asked);
    std::size_t hidden = 0;
    std::size_t seen = 0;
    for (std::size_t i = 0; i < red.rgba.size(); i += 4) {
        const bool isSame =
            std::equal(red.rgba.begin() + std::ptrdiff_t(i), red.rgba.begin() + std::ptrdiff_t(i + 4),
                       black.rgba.begin() + std::ptrdiff_t(i));
        hidden += isSame ? 1 : 0;
        seen += red.rgba[i] == 250 && red.rgba[i + 1] == 60 && red.rgba[i + 2] == 3 ? 1 : 0;
        for (std::size_t c = i; c < i + 3; ++c) ASSERT_GE(red.rgba[c], black.rgba[c]) << "light is added";
    }
    EXPECT_GT(hidden, 100u);
    EXPECT_GT(seen, 400u);
}

TEST_F(DrawnPictureTest, IsClearWhereNothingIsSeenWhereThatIsAskedFor) {
    PictureRequest asked = request(trace::Look::dvr);
    asked.sizePx = {64, 64};
    const DrawnPicture black = draw(asked);
    asked.isTransparent = true;
    const DrawnPicture clear = draw(asked);
    EXPECT_FALSE(isEmpty(clear, asked));
    std::size_t opaque = 0;
    for (std::size_t i = 0; i < clear.rgba.size(); i += 4) {
        const int alpha = clear.rgba[i + 3];
        opaque += alpha == 255 ? 1 : 0;
        for (std::size_t c = i; c < i + 3; ++c) {
            if (alpha == 255) {
                EXPECT_NEAR(clear.rgba[c], black.rgba[c], 1.0) << i;
            } else if (alpha == 0) {
                EXPECT_EQ(clear.rgba[c], 0) << i;
            }
        }
    }
    EXPECT_GT(opaque, 100u);
    EXPECT_EQ(clear.rgba[3], 0) << "a corner";
    asked.camera = Camera{.positionMm = {0.0, -2000.0, 0.0}, .targetMm = {0.0, -4000.0, 0.0}};
    EXPECT_TRUE(isEmpty(draw(asked), asked));
    asked.isTransparent = false;
    asked.background = {9, 9, 200};
    EXPECT_TRUE(isEmpty(draw(asked), asked));
}

TEST_F(DrawnPictureTest, IsLinearLightAndDepthWhereThatIsWanted) {
    PictureRequest asked = request(trace::Look::dvr);
    asked.isLinear = true;
    const DrawnPicture picture = draw(asked);
    EXPECT_TRUE(picture.rgba.empty());
    ASSERT_TRUE(picture.traced);
    EXPECT_EQ(picture.traced->width, 40);
    EXPECT_EQ(picture.traced->height, 30);
    EXPECT_FALSE(isEmpty(picture, asked));
}

TEST_F(DrawnPictureTest, ThatIsStoppedIsNone) {
    const CancelToken token;
    token.cancel();
    Progress progress({}, token);
    for (const double error : {0.0, 0.001}) {
        PictureRequest asked = request();
        asked.settings.errorThreshold = error;
        const auto stopped = drawPicture(device(), asked, progress);
        ASSERT_FALSE(stopped);
        EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
    }
}

// It ends where noise is small enough, or with about the most samples, and then says so.
TEST_F(DrawnPictureTest, TracesNoiseAwayAsFarAsItMay) {
    PictureRequest asked = request();
    asked.settings.errorThreshold = 0.2;
    asked.samplesPerPixel = 4096;
    const DrawnPicture good = draw(asked);
    EXPECT_TRUE(good.statistics.converged);
    EXPECT_TRUE(notesOf(good, asked).empty());

    asked.settings.errorThreshold = 1e-6;
    asked.samplesPerPixel = 8;
    const DrawnPicture noisy = draw(asked);
    EXPECT_FALSE(noisy.statistics.converged);
    EXPECT_GE(noisy.statistics.meanSamplesPerPixel, 8.0);
    ASSERT_EQ(notesOf(noisy, asked).size(), 1u);
    EXPECT_NE(notesOf(noisy, asked).front().sentence.english().find("noisier"), std::string::npos);
}

TEST_F(DrawnPictureTest, IsWrittenWithWhatIsKnownOfIt) {
    const PictureRequest asked = request(trace::Look::dvr);
    const DrawnPicture picture = draw(asked);
    RenderRecord record;
    record.preset = "cinematic-bone";
    record.notes = {Text("A note.")};
    record.add(asked, picture);
    const dicom::test::TemporaryFolder folder;
    ASSERT_TRUE(writePicture(folder / "a.png", picture, asked.sizePx, metadata(record)));
    const std::vector<std::string> keys{"macula:look", "macula:preset", "macula:samples", "macula:notes"};
    const auto read = image::readMetadata(folder / "a.png", keys);
    ASSERT_TRUE(read);
    std::map<std::string, std::string> values(read->begin(), read->end());
    EXPECT_EQ(values["macula:look"], "dvr");
    EXPECT_EQ(values["macula:preset"], "cinematic-bone");
    EXPECT_EQ(values["macula:samples"], "2");
    EXPECT_EQ(values["macula:notes"], "A note.");

    const auto json = toJson(record);
    EXPECT_EQ(json["width"], 40);
    EXPECT_EQ(json["height"], 30);
    EXPECT_EQ(json["samplesPerPixel"], 2);
    EXPECT_TRUE(json["window"].is_null());
}

// The names of a patient are in the images, and the folder is named after him: neither gets into a picture.
TEST_F(DrawnPictureTest, TellsNothingOfThePatient) {
    const dicom::test::TemporaryFolder parent;
    const std::filesystem::path folder = parent / "ROENTGEN-ANNA";
    const auto files =
        dicom::test::write(phantom::make({.size = {48, 42, 30}, .spacingMm = {6.4, 6.4, 10.0}}), folder);
    for (const std::filesystem::path& file : files) {
        std::ifstream stream(file, std::ios::binary);
        std::string bytes{std::istreambuf_iterator<char>(stream), {}};
        const std::size_t name = bytes.find("PHANTOM^MACULA");
        ASSERT_NE(name, std::string::npos);
        std::ofstream(file, std::ios::binary) << bytes.replace(name, 14, "ROENTGEN^ANNA ");
    }
    Progress progress;
    auto study = study::loadStudy(folder, "", progress);
    ASSERT_TRUE(study) << study.error().message;
    study::bringTo16Bits(*study);

    PictureRequest asked = request(trace::Look::dvr);
    asked.scene.volume = study->volume;
    RenderRecord record;
    record.seriesDigest = study->seriesDigest;
    record.preset = scene::publicPresetName(folder.string() + "/roentgen.json");
    record.lights = scene::publicLightsName(folder.string() + "/roentgen.hdr");
    record.notes = study->notes;
    record.add(asked, draw(asked));
    std::string inPictures;
    for (const auto& [key, value] : metadata(record)) inPictures += key + " " + value + "\n";
    for (const auto& [key, value] : metadata(SheetRequest{.volume = study->volume, .presets = {{}}}, *study))
        inPictures += key + " " + value + "\n";
    const auto key = InstallationKey::find();
    ASSERT_TRUE(key);
    EXPECT_NE(inPictures.find("macula:series " + key->digestOf(study->seriesDigest)), std::string::npos);
    EXPECT_EQ(inPictures.find(study->seriesDigest), std::string::npos) << "whose UID can be guessed";
    std::string told = toJson(record).dump() + inPictures;
    std::ranges::transform(told, told.begin(), [](unsigned char c) { return std::tolower(c); });
    EXPECT_NE(told.find(study->seriesDigest), std::string::npos);
    for (const char* word : {"roentgen", "anna"})
        EXPECT_EQ(told.find(word), std::string::npos) << word << told;
}

// Three presets in two panels: two rows, the third preset alone in the second panel.
TEST(PresetSheet, HasARowForEachPresetOfAPanel) {
    const SheetRequest request{.presets = std::vector<TransferFunction>(3), .tilePx = 10, .panels = 2};
    EXPECT_EQ(sizeOf(request), glm::ivec2(10 * 6 * 2, 20));
    EXPECT_EQ(placeOf(request, 1).panel, 0);
    EXPECT_EQ(placeOf(request, 1).row, 1);
    EXPECT_EQ(placeOf(request, 2).panel, 1);
    EXPECT_EQ(placeOf(request, 2).row, 0);
}

// A tile is the picture that the tracer alone makes, and what no preset fills stays black.
TEST_F(DrawnPictureTest, IsATileOfTheSheet) {
    const PictureRequest asked = request();
    SheetRequest sheet{.volume = asked.scene.volume,
                       .presets = std::vector(3, asked.scene.function),
                       .tilePx = 16,
                       .panels = 2,
                       .samplesPerPixel = 1};
    Progress progress;
    const std::vector<std::uint8_t> rgba = gpu::expectOk(drawSheet(device(), sheet, progress));
    const glm::ivec2 size = sizeOf(sheet);
    ASSERT_EQ(rgba.size(), 4u * std::size_t(size.x) * std::size_t(size.y));
    const auto tileAt = [&](int column, int row) {
        std::vector<std::uint8_t> tile;
        for (int y = 0; y < 16; ++y) {
            const auto from = rgba.begin() + 4 * ((row * 16 + y) * size.x + column * 16);
            tile.insert(tile.end(), from, from + 4 * 16);
        }
        return tile;
    };
    for (int look = 0; look < 6; ++look) {
        EXPECT_EQ(tileAt(look, 0), tileAt(look, 1)) << look;      // of the same preset
        EXPECT_EQ(tileAt(look, 0), tileAt(look + 6, 0)) << look;  // in the other panel
        EXPECT_EQ(tileAt(look + 6, 1), std::vector<std::uint8_t>(4 * 16 * 16)) << look;
    }
    PictureRequest alone = asked;
    alone.camera = frameBox(asked.scene.volume->worldBox(), sheet.view, 30.0, 1.0);
    alone.sizePx = {16, 16};
    alone.samplesPerPixel = 1;
    EXPECT_EQ(tileAt(0, 0), draw(alone).rgba);
}

}  // namespace
}  // namespace macula::pictures
