// A view that the window saved, drawn by the command.
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/paths.h"
#include "cli/run_command.h"
#include "image/image_file.h"

namespace macula::cli {
namespace {

using nlohmann::json;

json builtIn(const std::string& file) {
    return json::parse(readAll(macula::test::projectFolder() / "presets" / file));
}

json camera() {
    return {{"positionMm", {120.0, -620.0, 40.0}},
            {"targetMm", {0, 0, 0}},
            {"up", {0, 0, 1}},
            {"verticalFovDeg", 25.0}};
}

// All that a view has, each other than by default. Layout, slices and measurements are the window's alone.
json fullView() {
    const json slices{{"window", {{"center", 300}, {"width", 600}}}, {"inverted", true}};
    const json distance{{"kind", "distance"}, {"pointsMm", {{0, 0, 0}, {10, 0, 0}}}, {"normal", {0, 0, 1}}};
    return {{"version", 1},
            {"series", "phantom"},
            {"look", "cinematic"},
            {"shading", true},
            {"filter", "trilinear"},
            {"denoising", "denoised"},
            {"bounces", 3},
            {"exposure", 1.5},
            {"toneMap", "hue"},
            {"lightRotationDeg", 30.0},
            {"lightStrength", 0.75},
            {"preset", builtIn("transfer/cinematic-bone.json")},
            {"clip", builtIn("clip/left-half.json")},
            {"lights", builtIn("lights/rim.json")},
            {"leavesTableOut", true},
            {"camera", camera()},
            {"layout", "axial"},
            {"slices", slices},
            {"measurements", json::array({distance})}};
}

class SavedView : public CommandTest {
  protected:
    std::string writeView(const json& view) const { return write("view.json", view.dump(2)); }
    std::string writeCamera() const { return write("camera.json", camera().dump()); }

    Ran run(const std::vector<std::string>& more) const {
        std::vector<std::string> all{"render", "phantom:",   "-o",         at("a.png"), "--size",
                                     "32x24",  "--spp",      "2",          "--seed",    "5",
                                     "--json", at("a.json"), "--overwrite"};
        all.insert(all.end(), more.begin(), more.end());
        return runMacula(all);
    }
    std::vector<float> pixels(const std::vector<std::string>& more) const {
        const Ran ran = run(more);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        const auto picture = image::readImage(at("a.png"));
        EXPECT_TRUE(picture.ok());
        return picture ? picture->pixels : std::vector<float>{};
    }
    // What the report of the last picture says made it.
    json made() const {
        json report = json::parse(readAll(at("a.json")));
        for (const char* time : {"loadSeconds", "traceSeconds", "deviceMs", "nsPerSample"})
            report.erase(time);
        return report;
    }
    void expectRefused(const std::vector<std::string>& more, int exitCode, const std::string& words) const {
        const Ran ran = run(more);
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
        EXPECT_FALSE(std::filesystem::exists(at("a.png")));
    }
};

TEST_F(SavedView, GivesThePictureOfItsOptions) {
    const auto spelledOut = pixels({"--preset",
                                    "cinematic-bone",
                                    "--clip",
                                    "left-half",
                                    "--lights",
                                    "rim",
                                    "--remove-table",
                                    "--bounces",
                                    "3",
                                    "--denoise",
                                    "--exposure",
                                    "1.5",
                                    "--tone-map",
                                    "hue",
                                    "--light-rotation",
                                    "30",
                                    "--light-strength",
                                    "0.75",
                                    "--camera",
                                    writeCamera()});
    const json report = made();
    EXPECT_EQ(report["preset"], "cinematic-bone");
    EXPECT_EQ(pixels({"--session", writeView(fullView())}), spelledOut);
    EXPECT_EQ(made(), report) << "names of what is built in, too";
    EXPECT_NE(pixels({}), spelledOut);
}

TEST_F(SavedView, GivesTheWindowShadingAndFilterOfItsLook) {
    json view{{"version", 1}, {"look", "mip"}, {"windows", {{"mip", {{"center", 300}, {"width", 600}}}}}};
    EXPECT_EQ(pixels({"--session", writeView(view)}), pixels({"--look", "mip", "--window", "300,600"}));
    // The window of a projection is no other's.
    EXPECT_EQ(pixels({"--session", writeView(view), "--look", "average"}), pixels({"--look", "average"}));

    view = {{"version", 1},
            {"look", "dvr"},
            {"shading", true},
            {"preset", builtIn("transfer/cinematic-bone.json")}};
    const std::vector<std::string> cast{"--look", "dvr", "--preset", "cinematic-bone"};
    std::vector<std::string> shaded = cast;
    shaded.emplace_back("--shading");
    EXPECT_EQ(pixels({"--session", writeView(view)}), pixels(shaded));
    view["shading"] = false;
    EXPECT_EQ(pixels({"--session", writeView(view)}), pixels(cast));
    EXPECT_NE(pixels(shaded), pixels(cast));

    view = {{"version", 1}, {"filter", "stochastic"}, {"bounces", 2}};
    const std::string quality = write("quality.json", R"({"version": 1, "name": "a", "title": "A",
        "samplesPerPixel": 64, "bounces": 2, "filter": "stochastic", "denoise": false})");
    EXPECT_EQ(pixels({"--session", writeView(view)}), pixels({"--quality", quality}));
}

TEST_F(SavedView, CountsLessThanWhatIsGivenBesides) {
    json view = fullView();
    view.erase("leavesTableOut");
    const std::vector<std::string> options{
        "--preset", "cinematic-chest",  "--clip", "right-half",       "--lights",   "studio",     "--look",
        "clear",    "--bounces",        "2",      "--no-denoise",     "--exposure", "1",          "--view",
        "left",     "--light-rotation", "0",      "--light-strength", "1",          "--tone-map", "neutral"};
    std::vector<std::string> both = options;
    both.insert(both.end(), {"--session", writeView(view)});
    const auto plain = pixels(options);
    const json report = made();
    EXPECT_EQ(pixels(both), plain);
    EXPECT_EQ(made(), report);

    run({"--session", writeView(view), "--fov", "40"});
    EXPECT_EQ(made()["camera"]["verticalFovDeg"], 40.0);
    EXPECT_EQ(made()["camera"]["positionMm"], camera()["positionMm"]);

    // A preset is the window of a projection.
    view = {{"version", 1}, {"look", "mip"}, {"windows", {{"mip", {{"center", 300}, {"width", 600}}}}}};
    EXPECT_EQ(pixels({"--session", writeView(view), "--preset", "ct-bone"}),
              pixels({"--look", "mip", "--preset", "ct-bone"}));
}

// The preset of the view is that with the name, so both get the same matter.
TEST_F(SavedView, HasItsPresetWithTheMatterThatIsGiven) {
    const std::vector<std::string> matter{"--roughness", "0.15", "--reflectance", "0.3"};
    std::vector<std::string> named{"--preset", "cinematic-bone"};
    named.insert(named.end(), matter.begin(), matter.end());
    std::vector<std::string> saved{
        "--session", writeView({{"version", 1}, {"preset", builtIn("transfer/cinematic-bone.json")}})};
    const auto plain = pixels(saved);
    saved.insert(saved.end(), matter.begin(), matter.end());
    const auto wanted = pixels(named);
    const json report = made();
    EXPECT_EQ(report["preset"], "cinematic-bone");
    EXPECT_EQ(report["matter"]["roughness"], 0.15);
    EXPECT_EQ(pixels(saved), wanted);
    EXPECT_EQ(made(), report);
    EXPECT_NE(plain, wanted);
}

TEST_F(SavedView, OfANewerMaculaIsDrawnAllTheSame) {
    json view{{"version", 1}, {"exposure", 2.0}};
    const auto plain = pixels({"--session", writeView(view)});
    view["bookmarks"] = {{{"name", "lesion"}, {"atMm", {1, 2, 3}}}};
    EXPECT_EQ(pixels({"--session", writeView(view)}), plain);
}

TEST_F(SavedView, ThatCannotBeDrawnIsRefused) {
    expectRefused({"--session", writeView({{"version", 1}, {"series", "0123456789abcdef"}})}, 3,
                  "saved of another series");
    expectRefused({"--session", at("none.json")}, 3, "none.json");
    expectRefused({"--session", write("broken.json", R"({"version": 1, "look": )")}, 3, "broken.json");
    expectRefused({"--session", write("cut.json", fullView().dump().substr(0, 900))}, 3, "cut.json");
    expectRefused({"--session", write("list.json", "[]")}, 3, "list.json");
    expectRefused({"--session", writeView({{"version", 2}})}, 3, "need a newer Macula");
    expectRefused({"--session", writeCamera()}, 3, "version");
    expectRefused({"--session", writeView({{"version", 1}, {"bounces", 0}})}, 3, "bounces");
    expectRefused({"--session", ""}, 2, "--session is empty");
}

TEST_F(SavedView, IsNotRepeatedByTheNamesOfItsParts) {
    json view = fullView();
    view["clip"]["name"] = "doe-jane";
    view["lights"]["name"] = "doe-jane";
    view["preset"]["macula"]["name"] = "doe-jane";
    pixels({"--session", writeView(view)});
    EXPECT_EQ(readAll(at("a.png")).find("doe-jane"), std::string::npos);
    EXPECT_EQ(readAll(at("a.json")).find("doe-jane"), std::string::npos);
    for (const char* part : {"preset", "clip", "lights"}) EXPECT_EQ(made()[part], "custom");
}

class RecordedView : public SavedView {
  protected:
    Ran record(const std::string& folder, const std::vector<std::string>& more) const {
        std::vector<std::string> all{"hybrid",  writeBall(), "-o",          folder,   "--size",
                                     "32x24",   "--seconds", "0",           "--rest", "0",
                                     "--learn", "0",         "--no-session"};
        all.insert(all.end(), more.begin(), more.end());
        return runMacula(all);
    }
    static std::vector<json> framesOf(const std::string& folder) {
        std::vector<json> frames;
        std::istringstream lines(readAll(folder + "/frames.jsonl"));
        for (std::string line; std::getline(lines, line);) frames.push_back(json::parse(line));
        return frames;
    }
    static json cameraOf(const std::string& folder) {
        const std::vector<json> frames = framesOf(folder);
        return frames.empty() ? json() : frames.front()["camera"];
    }
};

// Looks without a model, and grey faces, are recorded as the window shows them.
TEST_F(RecordedView, BeginsFromItsCamera) {
    const json average{{"version", 1}, {"look", "average"}, {"camera", camera()}};
    const json greyFaces{
        {"version", 1}, {"look", "dvr"}, {"clip", builtIn("clip/corner-open.json")}, {"camera", camera()}};
    for (const json& view : {average, greyFaces}) {
        const std::string folder = at(view.contains("clip") ? "grey" : "average");
        const Ran ran = record(folder, {"--session", writeView(view)});
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        ASSERT_FALSE(framesOf(folder).empty());
        for (const json& frame : framesOf(folder)) {
            EXPECT_EQ(frame["camera"], camera());
            EXPECT_EQ(frame["model"]["splats"], 0);
        }
    }
}

TEST_F(RecordedView, CountsLessThanWhatIsGivenBesides) {
    const std::string view = writeView({{"version", 1}, {"look", "average"}, {"camera", camera()}});
    const Ran ran = record(at("left"), {"--session", view, "--view", "left"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const json position = cameraOf(at("left"))["positionMm"];
    EXPECT_GT(position[0].get<double>(), 100.0);
    EXPECT_NEAR(position[1].get<double>(), 0.0, 1.0);
}

// As of render: the second volume of the view is drawn where it is given, and else it is said.
TEST_F(RecordedView, HasItsSecondVolumeWhereThatIsGiven) {
    const json beside{{"series", "0123456789abcdef"}, {"link", "sameFrame"}, {"in3d", true}};
    json near = camera();  // the ball, 80 mm wide, fills most of the picture
    near["positionMm"] = {0.0, -200.0, 0.0};
    const std::string view =
        writeView({{"version", 1}, {"look", "dvr"}, {"camera", near}, {"beside", beside}});
    const auto brightness = [&](const std::string& folder) {
        std::string last;
        for (const json& frame : framesOf(folder)) last = frame.value("file", last);
        const auto picture = image::readImage(folder + "/" + last);
        EXPECT_TRUE(picture.ok());
        double sum = 0.0;
        if (picture)
            for (const float value : picture->pixels) sum += value;
        return picture ? sum / double(picture->pixels.size()) : 0.0;
    };
    const std::vector<std::string> alone{"--session", view, "--preset", "cinematic-bone"};
    const Ran without = record(at("alone"), alone);
    ASSERT_EQ(without.exitCode, 0) << without.err;
    EXPECT_NE(without.err.find("give it by --second"), std::string::npos) << without.err;
    std::vector<std::string> both = alone;
    both.insert(both.end(), {"--second", writeBall("second.nrrd"), "--second-preset", "ct-muscle"});
    const Ran with = record(at("both"), both);
    ASSERT_EQ(with.exitCode, 0) << with.err;
    EXPECT_EQ(with.err.find("give it by --second"), std::string::npos) << with.err;
    ASSERT_FALSE(framesOf(at("alone")).empty());
    ASSERT_FALSE(framesOf(at("both")).empty());
    for (const json& frame : framesOf(at("alone"))) EXPECT_EQ(frame["additions"], "none");
    for (const json& frame : framesOf(at("both")))
        EXPECT_TRUE(frame["additions"].get<std::string>().starts_with("with CT")) << frame["additions"];
    EXPECT_GT(std::abs(brightness(at("both")) - brightness(at("alone"))), 0.01);
}

TEST_F(RecordedView, ThatCannotBeRecordedIsRefused) {
    const Ran another =
        record(at("a"), {"--session", writeView({{"version", 1}, {"series", "0123456789abcdef"}})});
    EXPECT_EQ(another.exitCode, 3) << another.err;
    EXPECT_NE(another.err.find("saved of another series"), std::string::npos) << another.err;
    EXPECT_FALSE(std::filesystem::exists(at("a/frames.jsonl")));

    const Ran broken = record(at("b"), {"--session", write("broken.json", "{")});
    EXPECT_EQ(broken.exitCode, 3) << broken.err;
    EXPECT_NE(broken.err.find("broken.json"), std::string::npos) << broken.err;
    EXPECT_FALSE(std::filesystem::exists(at("b"))) << "no folder is made for what cannot be recorded";
}

}  // namespace
}  // namespace macula::cli
