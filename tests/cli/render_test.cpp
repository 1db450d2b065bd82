// Pictures from end to end: DICOM in, PNG and EXR out.
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "base/paths.h"
#include "base/phantom.h"
#include "cli/run_command.h"
#include "dicom/write/series_writer.h"
#include "image/image_file.h"
#include "pipeline/trace/look.h"
#include "segment/scene.h"

namespace macula::cli {
namespace {

class Render : public CommandTest {
  protected:
    image::Image render(const std::string& name, std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "render");
        arguments.insert(arguments.end(), {"-o", at(name), "--overwrite", "--size", "48x40", "--spp", "4"});
        const Ran ran = runMacula(arguments);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        auto image = image::readImage(at(name));
        EXPECT_TRUE(image.ok());
        return image.ok() ? *image : image::Image{};
    }
};

// Of the small phantom, where a test draws many pictures.
class RenderSmall : public Render {
  protected:
    image::Image render(const std::string& name, std::vector<std::string> arguments) {
        if (small_.empty()) small_ = writeSmallPhantom();
        arguments.insert(arguments.begin(), small_);
        return Render::render(name, std::move(arguments));
    }

  private:
    std::string small_;
};

double meanBrightness(const image::Image& image) {
    double sum = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); i += static_cast<std::size_t>(image.channels)) {
        sum += image.pixels[i] + image.pixels[i + 1] + image.pixels[i + 2];
    }
    return sum / (3.0 * image.width * image.height);
}

TEST_F(Render, PhantomToPng) {
    const image::Image image = render("a.png", {"--json", at("a.json")});
    EXPECT_EQ(image.width, 48);
    EXPECT_EQ(image.height, 40);
    EXPECT_GT(meanBrightness(image), 0.01);
    EXPECT_EQ(fileCount(), 2u);
    const auto statistics = nlohmann::json::parse(readAll(at("a.json")));
    EXPECT_EQ(statistics["samplesPerPixel"], 4);
    EXPECT_EQ(statistics["meanSamplesPerPixel"], 4.0);
    EXPECT_GT(statistics["estimatedError"], 0.01);
    EXPECT_EQ(statistics["converged"], false);  // nothing was asked for
    EXPECT_EQ(statistics["nonFiniteSamples"], 0);
    EXPECT_EQ(statistics["abandonedSamples"], 0);
    EXPECT_EQ(statistics["collisionsAboveBound"], 0);
    EXPECT_EQ(statistics["series"], "phantom");
    EXPECT_EQ(statistics["preset"], "cinematic-chest");
}

TEST_F(Render, UntilNoiseIsGone) {
    const Ran ran = runMacula(
        {"render", "-o", at("a.png"), "--size", "48x40", "--error", "0.06", "--json", at("a.json")});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    auto statistics = nlohmann::json::parse(readAll(at("a.json")));
    EXPECT_EQ(statistics["converged"], true);
    EXPECT_LE(statistics["estimatedError"], 0.06);
    EXPECT_GE(statistics["samplesPerPixel"], 8);
    EXPECT_GT(statistics["meanSamplesPerPixel"], statistics["samplesPerPixel"]);
    // Then --spp is the most that it may take.
    render("b.png", {"--error", "0.0001", "--json", at("b.json")});
    statistics = nlohmann::json::parse(readAll(at("b.json")));
    EXPECT_EQ(statistics["converged"], false);
    EXPECT_GE(statistics["meanSamplesPerPixel"], 4);
    EXPECT_LT(statistics["meanSamplesPerPixel"], 200);
    EXPECT_EQ(statistics["notes"].back(), "The picture is noisier than its limit of noise.");
}

// Somebody who says nothing of effort gets a picture to look at, and light as it was traced.
TEST_F(Render, EndsByItsNoiseWhereNobodySaysHowMuchWorkItIsWorth) {
    const auto drawn = [&](const char* name) {
        const Ran ran =
            runMacula({"render", "-o", at(name), "--overwrite", "--size", "48x40", "--json", at("a.json")});
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return nlohmann::json::parse(readAll(at("a.json")));
    };
    const auto picture = drawn("a.png");
    EXPECT_EQ(picture["denoised"], true);
    EXPECT_EQ(picture["converged"], true);
    EXPECT_LE(picture["estimatedError"], 0.1);
    EXPECT_LT(picture["meanSamplesPerPixel"], 256);
    const auto light = drawn("a.exr");
    EXPECT_EQ(light["denoised"], false);
    EXPECT_EQ(light["samplesPerPixel"], 64);
}

TEST_F(Render, FindsItsExposure) {
    render("a.png", {"--auto-exposure", "--light-strength", "0.05", "--json", at("a.json")});
    EXPECT_GT(nlohmann::json::parse(readAll(at("a.json")))["exposure"], 5.0);
    EXPECT_EQ(runMacula({"render", "-o", at("b.png"), "--auto-exposure", "--exposure", "2"}).exitCode, 2);
}

TEST_F(RenderSmall, ALensFogAndAToneMapAreTold) {
    const image::Image plain = render("a.png", {});
    for (const auto& more : std::vector<std::vector<std::string>>{{"--tone-map", "hue"},
                                                                  {"--lens-mm", "40"},
                                                                  {"--lens-mm", "40", "--focus-mm", "500"},
                                                                  {"--fog-mm", "80"}})
        EXPECT_NE(render("b.png", more).pixels, plain.pixels) << more.front();
    render("c.png", {"--tone-map", "hue", "--lens-mm", "40", "--focus-mm", "500", "--fog-mm", "80", "--json",
                     at("c.json")});
    const auto told = nlohmann::json::parse(readAll(at("c.json")));
    EXPECT_EQ(told["toneMap"], "hue");
    EXPECT_EQ(told["lensMm"], 40.0);
    EXPECT_EQ(told["focusMm"], 500.0);
    EXPECT_EQ(told["fogMm"], 80.0);
    render("d.png", {"--lens-mm", "40", "--json", at("d.json")});
    EXPECT_GT(nlohmann::json::parse(readAll(at("d.json")))["focusMm"], 100.0) << "found";
    // Fog takes light and coverage away, and leaves depths.
    EXPECT_LT(meanBrightness(render("e.exr", {"--fog-mm", "50"})), 0.9 * meanBrightness(render("f.exr", {})));
}

TEST_F(RenderSmall, WhatIsGivenItselfCountsMoreThanTheQuality) {
    const auto denoised = [&](const std::vector<std::string>& words) {
        std::vector<std::string> all = words;
        all.insert(all.end(), {"--json", at("q.json")});
        const image::Image image = render("q.png", all);
        return std::pair(nlohmann::json::parse(readAll(at("q.json")))["denoised"].get<bool>(), image.pixels);
    };
    const auto plain = denoised({"--bounces", "16"});
    EXPECT_FALSE(plain.first);
    const auto normal = denoised({"--quality", "normal"});
    EXPECT_TRUE(normal.first);
    EXPECT_NE(normal.second, plain.second);
    // The same picture otherwise: four samples and sixteen bounces.
    EXPECT_EQ(denoised({"--quality", "normal", "--no-denoise"}), plain);
    EXPECT_EQ(denoised({"--bounces", "16", "--denoise"}), normal);
}

TEST_F(RenderSmall, EveryLook) {
    for (const trace::LookTraits& traits : trace::kLooks) {
        const std::string look(traits.name);
        const image::Image image =
            render("l.png", {"--look", look, "--window", "0,2200", "--json", at("l.json")});
        EXPECT_GT(meanBrightness(image), look == "minip" ? -1.0 : 0.005) << look;
        const auto statistics = nlohmann::json::parse(readAll(at("l.json")));
        EXPECT_EQ(statistics["look"], look);
        EXPECT_EQ(statistics["samplesPerPixel"], 4);
        EXPECT_EQ(statistics["lights"], look == "clear" ? "even" : "studio");
    }
}

// In linear light, so that twice the light is twice the number; exposure is of the display alone.
TEST_F(RenderSmall, LightsExposureAndShading) {
    const double plain = meanBrightness(render("a.exr", {}));
    EXPECT_NEAR(meanBrightness(render("b.exr", {"--light-strength", "2"})) / plain, 2.0, 1e-3);
    EXPECT_NEAR(meanBrightness(render("c.exr", {"--exposure", "2"})) / plain, 1.0, 1e-6);
    EXPECT_GT(meanBrightness(render("d.png", {"--exposure", "2"})),
              1.1 * meanBrightness(render("a.png", {})));
    EXPECT_NE(meanBrightness(render("e.exr", {"--light-rotation", "90"})), plain);
    EXPECT_LT(meanBrightness(render("f.exr", {"--look", "dvr", "--shading"})),
              meanBrightness(render("g.exr", {"--look", "dvr"})));
}

TEST_F(Render, ExrHoldsLightAndDepth) {
    const image::Image image = render("a.exr", {"--view", "posterior"});
    ASSERT_EQ(image.channels, 5);
    int hits = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 5) {
        EXPECT_GE(image.pixels[i + 3], 0.0f);
        EXPECT_LE(image.pixels[i + 3], 1.0f + 1e-5f);
        const float depth = image.pixels[i + 4];
        EXPECT_FALSE(std::isnan(depth));
        if (std::isfinite(depth)) {
            ++hits;
            EXPECT_GT(depth, 100.0f);
            EXPECT_LT(depth, 3000.0f);
        }
    }
    EXPECT_GT(hits, 50);
}

// To a pixel of 40 at each end.
TEST_F(Render, WhatIsSeenFillsThePicture) {
    for (const std::string from : {"anterior", "left", "superior"}) {
        const image::Image image = render("a.exr", {"--view", from, "--preset", "cinematic-bone"});
        ASSERT_EQ(image.channels, 5);
        glm::ivec2 low(1000);
        glm::ivec2 high(-1);
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                if (image.pixels[std::size_t(5 * (y * image.width + x) + 3)] < 0.1f) continue;
                low = glm::min(low, glm::ivec2(x, y));
                high = glm::max(high, glm::ivec2(x, y) + 1);
            }
        }
        const glm::dvec2 part = glm::dvec2(high - low) / glm::dvec2(image.width, image.height);
        EXPECT_GE(std::max(part.x, part.y), 0.85) << from;
        EXPECT_LE(std::max(part.x, part.y), 0.95) << from;
    }
}

// The phantom's body is 264 mm high: so it is in the picture, by what that says of its height.
TEST_F(Render, ParallelRaysSayHowHighThePictureIs) {
    const image::Image image =
        render("a.exr", {"--parallel", "--view", "left", "--preset", "ct-muscle", "--json", at("a.json")});
    const auto camera = nlohmann::json::parse(readAll(at("a.json")))["camera"];
    const double heightMm = camera["parallelHeightMm"];
    int low = 1000;
    int high = -1;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (image.pixels[std::size_t(5 * (y * image.width + x) + 3)] < 0.3f) continue;
            low = std::min(low, y);
            high = std::max(high, y + 1);
        }
    }
    EXPECT_NEAR((high - low) * heightMm / image.height, 264.0, 2.0 * heightMm / image.height);
    // A camera from a file becomes parallel at its target.
    const std::string file = write("camera.json", R"({"positionMm": [0, -1000, 0], "targetMm": [0, 0, 0],
        "up": [0, 0, 1], "verticalFovDeg": 25})");
    render("b.png", {"--parallel", "--camera", file, "--json", at("b.json")});
    EXPECT_NEAR(nlohmann::json::parse(readAll(at("b.json")))["camera"]["parallelHeightMm"].get<double>(),
                2000.0 * std::tan(12.5 / 180.0 * 3.14159265358979), 1e-6);
}

TEST_F(RenderSmall, SameSeedSamePictureOtherSeedAnother) {
    const auto first = render("1.png", {"--seed", "5"}).pixels;
    EXPECT_EQ(first, render("2.png", {"--seed", "5"}).pixels);
    EXPECT_NE(first, render("3.png", {"--seed", "6"}).pixels);
}

TEST_F(Render, FilesInsteadOfNames) {
    const std::string camera = write("camera.json", R"({"positionMm": [0, -900, 0], "targetMm": [0, 0, 0],
        "up": [0, 0, 1], "verticalFovDeg": 25})");
    std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n";
    for (int i = 0; i < 8; ++i) hdr += std::string("\x80\x80\x80\x82", 4);
    const std::string preset = macula::test::projectFolder() / "presets/transfer/cinematic-bone.json";
    const image::Image image =
        render("a.png", {"--camera", camera, "--lights", write("sky.hdr", hdr), "--preset", preset});
    EXPECT_GT(meanBrightness(image), 0.01);
}

TEST_F(Render, MetadataSaysWhatMadeItAndNotWho) {
    ASSERT_EQ(runMacula({"phantom", at("study")}).exitCode, 0);
    const auto info = nlohmann::json::parse(runMacula({"info", at("study"), "--json", "--patient"}).out);
    const std::string uid = info["studies"][0]["series"][0]["seriesInstanceUid"];
    for (const char* name : {"a.png", "a.exr"}) {
        render(name, {at("study"), "--seed", "9"});
        const auto metadata = image::readMetadata(
            at(name),
            std::array<std::string, 4>{"Software", "macula:series", "macula:preset", "macula:seed"});
        ASSERT_TRUE(metadata.ok());
        ASSERT_EQ(metadata->size(), 4u) << name;
        EXPECT_TRUE((*metadata)[0].second.starts_with("Macula "));
        EXPECT_EQ((*metadata)[1].second.size(), 64u);
        EXPECT_EQ((*metadata)[2].second, "cinematic-chest");
        EXPECT_EQ((*metadata)[3].second, "9");
        const std::string bytes = readAll(at(name));
        for (const std::string& secret :
             {std::string("PHANTOM"), uid, folder_.string(), std::string("study")}) {
            EXPECT_EQ(bytes.find(secret), std::string::npos) << name << " holds " << secret;
        }
    }
}

TEST_F(Render, TheNameOfAUsersFileIsNotRepeated) {
    std::filesystem::copy_file(macula::test::projectFolder() / "presets/transfer/cinematic-bone.json",
                               at("DOE_JANE"));
    render("a.png", {"--preset", at("DOE_JANE"), "--json", at("a.json")});
    EXPECT_EQ(readAll(at("a.png")).find("DOE_JANE"), std::string::npos);
    EXPECT_EQ(readAll(at("a.json")).find("DOE_JANE"), std::string::npos);
    EXPECT_NE(readAll(at("a.json")).find("custom"), std::string::npos);
}

TEST_F(Render, ASecondVolumeIsInThePictureAndIsSaid) {
    const auto alone =
        render("alone.png", {"phantom:", "--preset", "cinematic-bone", "--json", at("alone.json")});
    const auto both =
        render("both.png", {"phantom:", "--preset", "cinematic-bone", "--second",
                            "phantom:", "--second-preset", "ct-muscle", "--json", at("both.json")});
    EXPECT_NE(both.pixels, alone.pixels);
    EXPECT_EQ(nlohmann::json::parse(readAll(at("alone.json")))["additions"], "none");
    EXPECT_EQ(nlohmann::json::parse(readAll(at("both.json")))["additions"], "with CT");
    // By default it has the colours that it has over slices; of projections it is no part.
    EXPECT_NE(
        render("colours.png", {"phantom:", "--preset", "cinematic-bone", "--second", "phantom:"}).pixels,
        alone.pixels);
    EXPECT_EQ(render("mip2.png", {"phantom:", "--look", "mip", "--second", "phantom:"}).pixels,
              render("mip.png", {"phantom:", "--look", "mip"}).pixels);
}

TEST_F(Render, ASecondVolumeThatIsNotThereIsRefused) {
    const std::vector<std::vector<std::string>> wrong{
        {"--second-preset", "ct-bone"},
        {"--second-series", "2"},
        {"--registration", "search"},
        {"--second", "phantom:", "--registration", "guess"},
        {"--second", "phantom:", "--second-preset", "nonsense"}};
    for (std::vector<std::string> arguments : wrong) {
        const std::string what = arguments.back();
        arguments.insert(arguments.begin(), {"render", "phantom:", "-o", at("a.png"), "--size", "16x16"});
        const Ran ran = runMacula(arguments);
        EXPECT_EQ(ran.exitCode, 2) << what << ran.err;
    }
    EXPECT_EQ(fileCount(), 0u);
}

TEST_F(Render, SegmentsThatNobodyCanMeanAreRefused) {
    for (const char* wrong : {"Liver", "keep:", "drop:Liver"}) {
        const Ran ran = runMacula({"render", "-o", at("a.png"), "--segments", wrong});
        EXPECT_EQ(ran.exitCode, 2) << wrong << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
    }
    const Ran phantom = runMacula({"render", "phantom:", "-o", at("a.png"), "--segments", "keep:Liver"});
    EXPECT_EQ(phantom.exitCode, 2) << phantom.err;
    EXPECT_EQ(fileCount(), 0u);
}

// A picture says that a table was removed only when one was, and where none is, nothing else goes.
TEST_F(Render, OfATableSaysWhetherOneWasRemoved) {
    const std::array<std::string, 1> key{"macula:tableRemoved"};
    const auto without = render("without.png", {"--json", at("without.json")});
    const auto asked = render("asked.png", {"--remove-table", "--json", at("asked.json")});
    EXPECT_EQ(asked.pixels, without.pixels);
    for (const std::string name : {"without", "asked"}) {
        EXPECT_EQ(nlohmann::json::parse(readAll(at(name + ".json")))["tableRemoved"], false) << name;
        EXPECT_EQ((*image::readMetadata(at(name + ".png"), key)).front().second, "no") << name;
    }

    Progress progress;
    const auto lying = segment::test::make({.size = {330, 280, 24}});
    ASSERT_TRUE(dicom::writeSeries(lying.volume, at("study"), {}, progress).ok());
    const auto below = [&](const std::vector<std::string>& besides) {
        std::vector<std::string> words{at("study"), "--view", "posterior", "--json", at("table.json")};
        words.insert(words.end(), besides.begin(), besides.end());
        const auto pixels = render("table.png", words).pixels;
        const bool isRemoved = nlohmann::json::parse(readAll(at("table.json")))["tableRemoved"];
        EXPECT_EQ((*image::readMetadata(at("table.png"), key)).front().second, isRemoved ? "yes" : "no");
        return std::pair(isRemoved, pixels);
    };
    const auto kept = below({"--keep-table"});
    const auto removed = below({"--remove-table"});
    EXPECT_FALSE(kept.first);
    EXPECT_TRUE(removed.first);
    EXPECT_NE(removed.second, kept.second);
    EXPECT_EQ(below({}), removed) << "it is sure what is patient";
    const Ran both = runMacula({"render", at("study"), "-o", at("b.png"), "--keep-table", "--remove-table"});
    EXPECT_EQ(both.exitCode, 2) << both.err;
}

// The picture says from where it is and why; who asks is given that.
TEST_F(Render, SaysFromWhereThePatientIsSeenAndWhy) {
    const auto viewed = [&](const std::vector<std::string>& besides) {
        std::vector<std::string> words{"--json", at("view.json")};
        words.insert(words.end(), besides.begin(), besides.end());
        render("view.png", words);
        const auto json = nlohmann::json::parse(readAll(at("view.json")));
        const std::array<std::string, 1> key{"macula:view"};
        EXPECT_EQ((*image::readMetadata(at("view.png"), key)).front().second, json["view"]);
        return std::pair(json["view"].get<std::string>(), json["whyView"].get<std::string>());
    };
    EXPECT_EQ(viewed({}), std::pair(std::string("turned"), std::string("body")));
    EXPECT_EQ(viewed({"--view", "three-quarter"}),
              std::pair(std::string("three-quarter"), std::string("chosen")));

    Progress progress;
    const Volume slab = phantom::make({.size = {64, 56, 10}, .spacingMm = {4.8, 4.8, 7.5}});
    ASSERT_TRUE(dicom::writeSeries(slab, at("slab"), {}, progress).ok());
    EXPECT_EQ(viewed({at("slab")}), std::pair(std::string("oblique"), std::string("short-scan")));
}

TEST_F(RenderSmall, LiesOverTheBackgroundThatIsAskedFor) {
    const auto cornerOf = [&](const std::string& background) {
        const image::Image image = render("b.png", {"--background", background, "--json", at("b.json")});
        EXPECT_EQ(nlohmann::json::parse(readAll(at("b.json")))["background"],
                  background == "white" ? "#ffffff" : background);
        const std::span<const float> corner(image.pixels.data(), std::size_t(image.channels));
        std::vector<int> bytes;
        for (const float value : corner) bytes.push_back(int(std::lround(255.0f * value)));
        return bytes;
    };
    EXPECT_EQ(cornerOf("white"), (std::vector<int>{255, 255, 255, 255}));
    EXPECT_EQ(cornerOf("#10f0ff"), (std::vector<int>{0x10, 0xf0, 0xff, 255}));
    EXPECT_EQ(cornerOf("transparent"), (std::vector<int>{0, 0, 0, 0}));
    const Ran ran = runMacula({"render", "-o", at("a.png"), "--background", "sky"});
    EXPECT_EQ(ran.exitCode, 2) << ran.err;
    EXPECT_NE(ran.err.find("#rrggbb"), std::string::npos) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(at("a.png")));
}

TEST_F(Render, AStatisticsFileThatCannotBeWrittenIsNoticedBeforeTheWork) {
    const Ran ran = runMacula({"render", "-o", at("a.png"), "--json", at("missing/a.json")});
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_FALSE(std::filesystem::exists(at("a.png")));
}

TEST_F(Render, DicomGivesThePictureOfTheVolumeItWasMadeFrom) {
    ASSERT_EQ(runMacula({"phantom", at("study")}).exitCode, 0);
    // A preset without surfaces: in the frame of a normal that has no part along an axis, the last bit of a
    // place turns paths elsewhere.
    const auto plain = [&](const char* name, std::vector<std::string> of) {
        of.insert(of.end(), {"--preset", "ct-bone"});
        return render(name, of).pixels;
    };
    EXPECT_EQ(plain("direct.png", {"phantom:"}), plain("dicom.png", {at("study")}));
    EXPECT_EQ(plain("first.png", {at("study"), "--series", "1"}), plain("again.png", {"phantom:"}));
    const Ran none = runMacula({"render", at("study"), "--series", "2", "-o", at("none.png")});
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_EQ(none.errorLines(), 1u) << none.err;
}

}  // namespace
}  // namespace macula::cli
