// Pictures of models of Gaussians: where what lies in them is worked out by hand, and what can be wrong.
#include <fmt/format.h>

#include <cmath>

#include "base/phantom.h"
#include "cli/run_command.h"
#include "image/image_file.h"
#include "pipeline/splat/files/model_file.h"

namespace macula::cli {
namespace {

// A model as trainers write it: degree 0, ascii, one line per splat.
struct Dot {
    glm::vec3 position;
    glm::vec3 colour;  // 0 to 1, as displayed
    float deviation = 0.05f;
};
std::string foreignPly(const std::vector<Dot>& dots) {
    std::string text = fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n", dots.size());
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2", "opacity",
                             "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"})
        text += fmt::format("property float {}\n", name);
    text += "end_header\n";
    for (const Dot& dot : dots) {
        const glm::vec3 dc = (dot.colour - 0.5f) / 0.28209479f;
        const float scale = std::log(dot.deviation);
        text += fmt::format("{} {} {} 0 0 0 {} {} {} 20 {} {} {} 1 0 0 0\n", dot.position.x, dot.position.y,
                            dot.position.z, dc.x, dc.y, dc.z, scale, scale, scale);
    }
    return text;
}

std::string cameraJson(const std::string& name, const std::string& position, const std::string& rotation) {
    return fmt::format(
        R"({{"id": 0, "img_name": "{}", "width": 64, "height": 48, "position": {}, "rotation": {}, "fy": 50, "fx": 50}})",
        name, position, rotation);
}
const char* const kAlongZ = "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]";

constexpr glm::vec3 kRed{1, 0, 0};
constexpr glm::vec3 kGreen{0, 1, 0};

class SplatRender : public CommandTest {
  protected:
    image::Image draw(const std::vector<std::string>& arguments, const std::string& name) {
        std::vector<std::string> words{"splat-render"};
        words.insert(words.end(), arguments.begin(), arguments.end());
        ran_ = runMacula(words);
        EXPECT_EQ(ran_.exitCode, 0) << ran_.err;
        auto image = image::readImage(at(name));
        EXPECT_TRUE(image.ok()) << name;
        return image.ok() ? *image : image::Image{};
    }
    void expectRefused(int exitCode, const std::string& words, const std::vector<std::string>& arguments) {
        const std::size_t before = fileCount();
        std::vector<std::string> all{"splat-render"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Ran ran = runMacula(all);
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
        EXPECT_EQ(fileCount(), before) << "something was left behind";
    }
    Ran ran_;
};

const float* pixelOf(const image::Image& image, int column, int row) {
    const std::size_t pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                              static_cast<std::size_t>(column);
    return &image.pixels[pixel * static_cast<std::size_t>(image.channels)];
}

// Centre of mass of one channel, in pixels with their centres at 0.5.
glm::dvec2 centreOf(const image::Image& image, int channel) {
    glm::dvec2 sum(0.0);
    double mass = 0.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double v = pixelOf(image, x, y)[channel];
            sum += v * glm::dvec2(x + 0.5, y + 0.5);
            mass += v;
        }
    }
    return sum / std::max(mass, 1e-9);
}

TEST_F(SplatRender, AForeignModelIsWhereItsCamerasSeeIt) {
    const std::string model = write("model.ply", foreignPly({{{2, 2, 0}, kRed}, {{1, 3, 0}, kGreen}}));
    // From (1, 2, -10) along z, x to the right and y down: red is at (1, 0, 10), green at (0, 1, 10). The
    // second stands at (-9, 2, 1) and looks along x, so that right is -z: red is at (1, 0, 11), green at
    // (1, 1, 10). Were the matrix taken for its transpose it would look the other way.
    const std::string cameras = write(
        "cameras.json", "[" + cameraJson("front.JPG", "[1, 2, -10]", kAlongZ) + "," +
                            cameraJson("side", "[-9, 2, 1]", "[[0, 0, 1], [0, 1, 0], [-1, 0, 0]]") + "]");
    const image::Image front = draw({model, "--cameras", cameras, "-o", at("out")}, "out/front.png");
    ASSERT_EQ(front.width, 64);
    ASSERT_EQ(front.height, 48);
    const double close = 0.05;
    EXPECT_LT(glm::distance(centreOf(front, 0), glm::dvec2(32 + 50 * 0.1, 24)), close);
    EXPECT_LT(glm::distance(centreOf(front, 1), glm::dvec2(32, 24 + 50 * 0.1)), close);
    const image::Image side = *image::readImage(at("out/side.png"));
    EXPECT_LT(glm::distance(centreOf(side, 0), glm::dvec2(32 + 50.0 / 11, 24)), close);
    EXPECT_LT(glm::distance(centreOf(side, 1), glm::dvec2(32 + 50 * 0.1, 24 + 50 * 0.1)), close);
    EXPECT_EQ(fileCount("out"), 2u);

    // At another size: the same height of view, and the principal point in the middle of the wider picture.
    const image::Image wide =
        draw({model, "--cameras", cameras, "-o", at("wide"), "--size", "192x96"}, "wide/front.png");
    ASSERT_EQ(wide.width, 192);
    EXPECT_LT(glm::distance(centreOf(wide, 0), glm::dvec2(96 + 100 * 0.1, 48)), close);
    // Shrunken, and rounded on each side, as a trainer does it: all of the same picture. 64 x 48 by 1.5.
    const image::Image less =
        draw({model, "--cameras", cameras, "-o", at("less"), "--size", "42x32"}, "less/front.png");
    EXPECT_LT(glm::distance(centreOf(less, 0), glm::dvec2(42.0 / 64 * (32 + 50 * 0.1), 16)), close);
    // Macula's own camera: a field of view of 90 degrees over 48 rows has a focal length of 24 px.
    const std::string own = write(
        "own.json",
        R"({"positionMm": [1, 2, -10], "targetMm": [1, 2, 0], "up": [0, -1, 0], "verticalFovDeg": 90})");
    const image::Image small =
        draw({"--camera", own, model, "-o", at("own"), "--size", "64x48"}, "own/own.png");
    EXPECT_LT(glm::distance(centreOf(small, 0), glm::dvec2(32 + 24 * 0.1, 24)), close);
}

TEST_F(SplatRender, ThePatientsLeftIsOnTheRightOfAPictureFromTheFront) {
    splat::Splats model;
    model.originMm = {12, -7, 5};
    model.resize(2);
    model.position[0] = phantom::markerCentreMm() - model.originMm;
    model.logScale[0] = glm::vec3(1.0f);
    model.dc[0] = glm::vec3(0.8, -2, -2);  // red, and not so bright that the tone map bleaches it
    model.position[1] = glm::dvec3(-60, 0, -40) - model.originMm;
    model.logScale[1] = glm::vec3(1.0f);
    model.dc[1] = glm::vec3(-2, 0.8, -2);
    model.opacityLogit = {5, 5};
    const std::string camera = write(
        "front.json",
        R"({"positionMm": [0, -700, 0], "targetMm": [0, 0, 0], "up": [0, 0, 1], "verticalFovDeg": 30})");
    for (const std::string format : {"ply", "spz"}) {
        ASSERT_TRUE(splat::writeModel(at("model." + format), model).ok());
        const image::Image image =
            draw({at("model." + format), "--camera", camera, "-o", at(format), "--size", "120x100"},
                 format + "/front.png");
        const glm::dvec3 marker = phantom::markerCentreMm();
        const double focal = 50 / std::tan(glm::radians(15.0));
        const auto place = [&](const glm::dvec3& p) {
            return glm::dvec2(60 + focal * p.x / (p.y + 700), 50 - focal * p.z / (p.y + 700));
        };
        ASSERT_GT(marker.x, 20.0);  // the patient's left
        EXPECT_GT(centreOf(image, 0).x, 62.0) << format;
        EXPECT_LT(glm::distance(centreOf(image, 0), place(marker)), 0.1) << format;
        EXPECT_LT(glm::distance(centreOf(image, 1), place({-60, 0, -40})), 0.1) << format;
    }
}

// From the volume to a picture of the model, by both formats: what is cut out around the marker is where the
// marker is, and not on the other side.
TEST_F(SplatRender, TheMarkerOfATrainedModelIsOnThePatientsLeft) {
    const auto [low, high] = phantom::make().worldBox();
    const glm::dvec3 marker = phantom::markerCentreMm();
    const double around = phantom::markerHalfEdgeMm() + 2.0;
    const auto list = [](const glm::dvec3& p) { return fmt::format("[{}, {}, {}]", p.x, p.y, p.z); };
    const std::string clip = write(
        "marker.json",
        fmt::format(
            R"({{"version": 1, "name": "marker", "title": "The marker", "box": {{"low": {}, "high": {}, "keep": "inside"}}}})",
            list((marker - around - low) / (high - low)), list((marker + around - low) / (high - low))));
    for (const std::string format : {"ply", "spz"}) {
        const Ran trained =
            runMacula({"train", "phantom:", "--clip", clip, "--points", "400", "--views", "6", "--size", "48",
                       "--spp", "4", "--iterations", "40", "-o", at("marker." + format)});
        ASSERT_EQ(trained.exitCode, 0) << trained.err;
        const auto model = splat::readModel(at("marker." + format));
        ASSERT_TRUE(model.ok());
        glm::dvec3 centre = model->splats.originMm;
        for (const glm::vec3& p : model->splats.position)
            centre += glm::dvec3(p) / double(model->splats.size());
        EXPECT_LT(glm::distance(centre, marker), 3.0) << format;

        const std::string camera = write(
            "front.json",
            R"({"positionMm": [0, -700, 0], "targetMm": [0, 0, 0], "up": [0, 0, 1], "verticalFovDeg": 30})");
        const image::Image image =
            draw({at("marker." + format), "--camera", camera, "-o", at(format), "--size", "120x100"},
                 format + "/front.png");
        const double focal = 50 / std::tan(glm::radians(15.0));
        const glm::dvec2 place(60 + focal * marker.x / (marker.y + 700),
                               50 - focal * marker.z / (marker.y + 700));
        EXPECT_LT(glm::distance(centreOf(image, 0), place), 1.0) << format;
        double right = 0.0;
        for (int y = 0; y < 100; ++y)
            for (int x = 0; x < 60; ++x) right += pixelOf(image, x, y)[0];
        EXPECT_EQ(right, 0.0) << "nothing is on the patient's right";
    }
}

// Ours are in the patient's axes: left, superior and anterior are where they are seen from each side.
TEST_F(SplatRender, WithoutACameraAllOfTheModelIsInView) {
    splat::Splats model;
    model.originMm = {500, -300, 1000};
    model.resize(3);
    model.position = {{150, 0, 0}, {0, 0, 90}, {0, -60, 0}};  // left, superior, anterior
    model.dc = {{0.8, -2, -2}, {-2, 0.8, -2}, {-2, -2, 0.8}};
    model.opacityLogit = {5, 5, 5};
    model.logScale = {glm::vec3(1.0f), glm::vec3(1.0f), glm::vec3(1.0f)};
    ASSERT_TRUE(splat::writeModel(at("model.ply"), model).ok());
    const image::Image front =
        draw({at("model.ply"), "-o", at("out"), "--size", "240x200"}, "out/anterior.png");
    EXPECT_EQ(fileCount("out"), 1u);
    ASSERT_EQ(front.width, 240);
    // The box, (-3 dots beyond) 0 to 150 by 0 to 90 mm, is in the middle: its edges are as far from those of
    // the picture on the left as on the right.
    EXPECT_NEAR(centreOf(front, 0).x + centreOf(front, 1).x, 240.0, 2.0);
    EXPECT_GT(centreOf(front, 0).x, 170.0) << "the patient's left is on the right";
    EXPECT_LT(centreOf(front, 0).x, 236.0);
    EXPECT_LT(centreOf(front, 1).y, 80.0) << "superior is up";
    EXPECT_GT(centreOf(front, 0).y, 120.0);
    const image::Image left =
        draw({at("model.ply"), "-o", at("out"), "--size", "240x200", "--from", "left", "--from", "superior"},
             "out/left.png");
    EXPECT_LT(centreOf(left, 2).x, centreOf(left, 1).x - 20.0) << "anterior is on the left";
    EXPECT_LT(centreOf(left, 1).y, centreOf(left, 2).y - 20.0);
    for (const char* name : {"out/left.png", "out/superior.png"})
        EXPECT_NE(ran_.err.find("Wrote " + at(name) + " in "), std::string::npos) << ran_.err;
    const image::Image above = *image::readImage(at("out/superior.png"));
    EXPECT_LT(centreOf(above, 2).y, centreOf(above, 1).y - 20.0) << "anterior is up";
    EXPECT_LT(centreOf(above, 0).x, centreOf(above, 1).x - 20.0) << "the patient's left is on the left";
}

// One made elsewhere says nothing of that: along its own +z, x to the right and y down, however small it is
// and whatever lies astray.
TEST_F(SplatRender, AForeignModelWithoutACameraIsSeenAlongItsOwnZ) {
    std::vector<Dot> dots;
    for (int i = 0; i < 200; ++i) dots.push_back({{0.0001f * float(i % 10), 0, 0}, kGreen, 0.0002f});
    for (int i = 0; i < 5; ++i) dots.push_back({{0.01f, 0, 0}, kRed, 0.0002f});
    for (int i = 0; i < 5; ++i) dots.push_back({{0, 0.01f, 0}, {0.0f, 0.0f, 1.0f}, 0.0002f});
    dots.push_back({{5000, 5000, -5000}, kRed, 0.0002f});
    const std::string model = write("model.ply", foreignPly(dots));
    const image::Image image = draw({model, "-o", at("out"), "--size", "100x100"}, "out/along-z.png");
    EXPECT_NE(ran_.err.find("does not say which way is up"), std::string::npos) << ran_.err;
    const glm::dvec2 green = centreOf(image, 1);
    EXPECT_GT(centreOf(image, 0).x, green.x + 40.0);
    EXPECT_GT(centreOf(image, 2).y, green.y + 40.0);
    EXPECT_LT(centreOf(image, 0).x, 100.0);
    EXPECT_LT(centreOf(image, 2).y, 100.0);
    const std::string none = write("none.ply", foreignPly({}));
    draw({none, "-o", at("none"), "--size", "16x16"}, "none/along-z.png");
    EXPECT_NE(ran_.err.find("holds no splats"), std::string::npos) << ran_.err;
}

TEST_F(SplatRender, ColoursAndBackground) {
    // One splat that fills the picture: alpha is 0.99, so 0.01 of the background is there too.
    const std::string cameras = write("cameras.json", "[" + cameraJson("a", "[0, 0, -10]", kAlongZ) + "]");
    const std::string foreign = write("foreign.ply", foreignPly({{{0, 0, 0}, {0.2, 0.5, 0.9}, 1000.0f}}));
    const auto middle = [](const image::Image& image) {
        const float* p = pixelOf(image, 32, 24);
        return glm::dvec3(p[0], p[1], p[2]) * 255.0;
    };
    const image::Image shown =
        draw({foreign, "--cameras", cameras, "-o", at("f"), "--background", "1,0.5,0", "--exposure", "3"},
             "f/a.png");
    EXPECT_NE(ran_.err.find("--exposure does nothing"), std::string::npos) << ran_.err;
    const glm::dvec3 expected = 255.0 * (0.99 * glm::dvec3(0.2, 0.5, 0.9) + 0.01 * glm::dvec3(1, 0.5, 0));
    EXPECT_LT(glm::distance(middle(shown), expected), 1.0);

    splat::Splats own;
    own.resize(1);
    own.logScale[0] = glm::vec3(6.0f);
    own.opacityLogit[0] = 20;
    ASSERT_TRUE(splat::writeModel(at("own.ply"), own).ok());
    const image::Image mapped =
        draw({at("own.ply"), "--cameras", cameras, "-o", at("o"), "--exposure", "0.5", "--depth"}, "o/a.png");
    // Half of 0.99 of grey 0.5, less 0.04 by the tone map, encoded.
    const double linear = 0.5 * 0.99 * 0.5 - 0.04;
    const double encoded = 255.0 * (1.055 * std::pow(linear, 1 / 2.4) - 0.055);
    EXPECT_LT(glm::distance(middle(mapped), glm::dvec3(encoded)), 1.8);
    // The background is shown as it was asked for, also through the tone map.
    own.position[0] = {0, 0, -500};  // behind the eye
    ASSERT_TRUE(splat::writeModel(at("away.ply"), own).ok());
    const image::Image away = draw(
        {at("away.ply"), "--cameras", cameras, "-o", at("b"), "--background", "0.95,0.5,0.25"}, "b/a.png");
    EXPECT_NE(ran_.err.find("Nothing of the model"), std::string::npos) << ran_.err;
    EXPECT_LT(glm::distance(middle(away), 255.0 * glm::dvec3(0.95, 0.5, 0.25)), 1.8);

    const image::Image exr = *image::readImage(at("o/a.exr"));
    const float* p = pixelOf(exr, 32, 24);
    EXPECT_NEAR(p[0], 0.99 * 0.5, 1e-5);  // not exposed
    ASSERT_EQ(exr.channels, 5);
    EXPECT_NEAR(p[4], 10.0, 1e-4);
}

TEST_F(SplatRender, NamesAreSafeAndNothingIsReplaced) {
    const std::string model = write("model.ply", foreignPly({{{0, 0, 0}, kRed}}));
    std::string list;
    for (const char* name : {"../../evil.png", "a/0001.jpg", "b/0001.jpg", "A_0001", "/home/somebody/x.png",
                             "", "...", "C:\\\\data\\\\y.png"})
        list += (list.empty() ? "[" : ",") + cameraJson(name, "[0, 0, -10]", kAlongZ);
    const std::string cameras = write("cameras.json", list + "]");
    draw({model, "--cameras", cameras, "-o", at("deep/out")}, "deep/out/evil.png");
    for (const char* name : {"a_0001", "b_0001", "A_0001_2", "x", "camera_0005", "camera_0006", "y"})
        EXPECT_TRUE(std::filesystem::exists(at(fmt::format("deep/out/{}.png", name)))) << name;
    EXPECT_EQ(fileCount("deep/out"), 8u);
    expectRefused(2, "--overwrite", {model, "--cameras", cameras, "-o", at("deep/out")});
    draw({model, "--cameras", cameras, "-o", at("deep/out"), "--overwrite"}, "deep/out/x.png");
}

TEST_F(SplatRender, AModelWithoutUsableSplatsIsAnEmptyPictureAndSaysSo) {
    const std::string cameras = write("cameras.json", "[" + cameraJson("a", "[0, 0, -10]", kAlongZ) + "]");
    const std::string none = write("none.ply", foreignPly({}));
    const image::Image image =
        draw({none, "--cameras", cameras, "-o", at("n"), "--background", "0,0,1"}, "n/a.png");
    EXPECT_NE(ran_.err.find("holds no splats"), std::string::npos) << ran_.err;
    for (std::size_t i = 0; i < image.pixels.size(); i += std::size_t(image.channels))
        ASSERT_EQ(image.pixels[i + 2] - image.pixels[i], 1.0f);
    const std::string bad = write("bad.ply", foreignPly({{{NAN, 0, 0}, kRed}, {{0, 0, 0}, kGreen}}));
    EXPECT_GT(centreOf(draw({bad, "--cameras", cameras, "-o", at("b")}, "b/a.png"), 1).x, 31.0);
    EXPECT_NE(ran_.err.find("note: 1 of the model's splats"), std::string::npos) << ran_.err;
}

TEST_F(SplatRender, BadInput) {
    const std::string model = write("model.ply", foreignPly({{{0, 0, 0}, kRed}}));
    const std::string good = write("good.json", "[" + cameraJson("a", "[0, 0, -10]", kAlongZ) + "]");
    const auto with = [&](const std::string& cameras) {
        return std::vector<std::string>{model, "--cameras", write("c.json", cameras), "-o", at("out")};
    };
    const auto plus = [&](const std::string& option, const std::string& value) {
        return std::vector<std::string>{model, "--cameras", good, "-o", at("out"), option, value};
    };
    write("c.json", "");
    expectRefused(3, "does not exist", {at("no.ply"), "--cameras", good, "-o", at("out")});
    expectRefused(3, "no PLY, SPZ, glTF or .macula model", {good, "--cameras", good, "-o", at("out")});
    expectRefused(3, "macula: ", {model, "--cameras", at("no.json"), "-o", at("out")});
    expectRefused(2, "made elsewhere", {model, "--from", "left", "-o", at("out")});
    expectRefused(2, "front is no direction", {model, "--from", "front", "-o", at("out")});
    expectRefused(2, "--from", {model, "--from", "left", "--cameras", good, "-o", at("out")});
    expectRefused(2, "--output", {model, "--cameras", good});
    expectRefused(2, "--camera", plus("--camera", good));
    expectRefused(3, "Give it as --cameras", {model, "--camera", good, "-o", at("out")});
    expectRefused(3, "no cameras", with("[]"));
    expectRefused(3, "no list of cameras", with("{}"));
    expectRefused(3, "[0].", with("[{}]"));
    expectRefused(3, "[1].position",
                  with("[" + cameraJson("a", "[0, 0, -10]", kAlongZ) + "," +
                       cameraJson("b", "[0, null, 0]", kAlongZ) + "]"));
    expectRefused(3, "line 1", with("[" + cameraJson("a", "[0, NaN, 0]", kAlongZ) + "]"));
    expectRefused(3, "[0].rotation", with("[" + cameraJson("a", "[0, 0, 0]", "[[1, 0], [0, 1]]") + "]"));
    // A mirror, and a matrix that is none.
    expectRefused(3, "Camera [0]",
                  with("[" + cameraJson("a", "[0, 0, 0]", "[[-1, 0, 0], [0, 1, 0], [0, 0, 1]]") + "]"));
    expectRefused(3, "Camera [0]",
                  with("[" + cameraJson("a", "[0, 0, 0]", "[[0, 0, 0], [0, 0, 0], [0, 0, 0]]") + "]"));
    expectRefused(2, "--size", plus("--size", "20000x10"));
    expectRefused(2, "--background", plus("--background", "1,2"));
    expectRefused(2, "--background", plus("--background", "255,0,0"));
    expectRefused(2, "--background", plus("--background", "nan,0,0"));
    expectRefused(2, "--near", plus("--near", "0"));
    expectRefused(2, "--near", plus("--near", "nan"));
    expectRefused(2, "--exposure", plus("--exposure", "nan"));
    expectRefused(2, "macula: ", plus("--device", "no such device"));
    write("file", "");
    expectRefused(2, "cannot be made", {model, "--cameras", good, "-o", at("file")});
}

}  // namespace
}  // namespace macula::cli
