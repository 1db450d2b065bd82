#include "scene/camera/camera_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

#include "scene/camera/orbit_camera.h"

namespace macula::scene {
namespace {

namespace fs = std::filesystem;

class CameraPathTest : public testing::Test {
  protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        file_ = fs::temp_directory_path() / (std::string("macula-path-") + test->name() + ".json");
    }
    void TearDown() override { fs::remove(file_); }
    Result<CameraPath> read(const std::string& text) {
        std::ofstream(file_) << text;
        return readCameraPath(file_);
    }
    static std::string stop(const std::string& atS, const std::string& positionMm) {
        return R"({"atS": )" + atS + R"(, "camera": {"positionMm": )" + positionMm +
               R"(, "targetMm": [0, 0, 0], "up": [0, 0, 1], "verticalFovDeg": 30}})";
    }
    fs::path file_;
};

TEST_F(CameraPathTest, GoesFromStopToStop) {
    const auto path = read("[" + stop("0", "[0, -100, 0]") + "," + stop("2", "[200, 0, 0]") + "]");
    ASSERT_TRUE(path.ok());
    EXPECT_EQ(path->seconds(), 2.0);
    EXPECT_EQ(cameraAt(*path, -1.0), path->stops[0].camera);
    EXPECT_EQ(cameraAt(*path, 0.0), path->stops[0].camera);
    EXPECT_EQ(cameraAt(*path, 2.0), path->stops[1].camera);
    EXPECT_EQ(cameraAt(*path, 1e9), path->stops[1].camera);
    // Halfway around, at the mean distance.
    const Camera half = cameraAt(*path, 1.0);
    EXPECT_NEAR(glm::length(half.positionMm), 150.0, 1e-9);
    EXPECT_NEAR(half.positionMm.x, 150.0 / std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(half.positionMm.y, -150.0 / std::sqrt(2.0), 1e-9);
}

// Opposite stops, and up along the view halfway: a camera all the same.
TEST_F(CameraPathTest, IsACameraAtEveryTime) {
    const auto opposite = read("[" + stop("0", "[0, -100, 0]") + "," + stop("1", "[0, 100, 0]") + "]");
    ASSERT_TRUE(opposite.ok());
    const auto over = read("[" + stop("0", "[1, -100, 0]") + "," + stop("1", "[0, 0.001, 100]") + "]");
    ASSERT_TRUE(over.ok());
    for (const CameraPath& path : {*opposite, *over})
        for (int i = 0; i <= 100; ++i) EXPECT_TRUE(basis(cameraAt(path, i / 100.0)).ok()) << i;
}

TEST_F(CameraPathTest, SaysWhichStopIsWrong) {
    const std::string good = stop("0", "[0, -100, 0]");
    const auto messageOf = [&](const std::string& text) {
        const auto path = read(text);
        EXPECT_FALSE(path.ok());
        EXPECT_EQ(path.error().code, ErrorCode::inputNotUsable);
        return path.error().message.english() + " " + path.error().hint.english();
    };
    EXPECT_NE(messageOf("[]"), "");
    EXPECT_NE(messageOf("[" + stop("1", "[0, -100, 0]") + "]").find("0 for the first"), std::string::npos);
    EXPECT_NE(messageOf("[" + good + "," + stop("0", "[1, -100, 0]") + "]").find("later time"),
              std::string::npos);
    EXPECT_NE(messageOf("[" + good + "," + stop("1", "[0, 0, 0]") + "]").find("Camera 2"), std::string::npos);
    EXPECT_NE(messageOf("[" + good + "," + stop("1e400", "[0, -100, 0]") + "]"), "");
}

TEST_F(CameraPathTest, ATurntableGoesAroundAtConstantSpeed) {
    Camera camera;
    camera.positionMm = {0.0, -500.0, 0.0};
    const CameraPath path = turntable(camera, 8.0, 4.0);
    EXPECT_EQ(path.seconds(), 4.0);
    const glm::dvec3 quarter = cameraAt(path, 2.0).positionMm;
    EXPECT_NEAR(quarter.x, 500.0, 1e-6);  // the patient's left
    EXPECT_NEAR(quarter.y, 0.0, 1e-6);
    EXPECT_NEAR(cameraAt(path, 4.0).positionMm.y, 500.0, 1e-6);
    EXPECT_NEAR(glm::length(cameraAt(path, 0.123).positionMm), 500.0, 0.5);
    EXPECT_EQ(turntable(camera, 8.0, 0.0).stops.size(), 1u);
}

// A movie of a parallel view has no perspective between its stops either.
TEST_F(CameraPathTest, ATurntableOfAParallelViewStaysParallel) {
    Camera camera;
    camera.positionMm = {0.0, -500.0, 0.0};
    camera = inParallel(camera);
    const CameraPath path = turntable(camera, 8.0, 4.0);
    for (int i = 0; i <= 100; ++i)
        EXPECT_NEAR(cameraAt(path, 0.04 * i).parallelHeightMm, camera.parallelHeightMm, 1e-6) << i;
}

TEST_F(CameraPathTest, AParallelPictureGrowsByTheSameFactorInTheSameTime) {
    Camera low;
    low.positionMm = {0.0, -500.0, 0.0};
    Camera high = low;
    low.parallelHeightMm = 100.0;
    high.parallelHeightMm = 400.0;
    for (const bool isRolled : {false, true}) {
        if (isRolled) low.up = high.up = glm::normalize(glm::dvec3(1.0, 0.0, 2.0));
        const CameraPath path{{{.atS = 0.0, .camera = low}, {.atS = 2.0, .camera = high}}};
        EXPECT_NEAR(cameraAt(path, 1.0).parallelHeightMm, 200.0, 1e-6) << isRolled;
        EXPECT_EQ(cameraAt(path, 2.0), high);
    }
}

TEST_F(CameraPathTest, FromParallelRaysToAnEyeTheWayIsThatOfAnEye) {
    Camera eye;
    eye.positionMm = {0.0, -500.0, 0.0};
    for (const bool isRolled : {false, true}) {
        if (isRolled) eye.up = glm::normalize(glm::dvec3(1.0, 0.0, 2.0));
        Camera rays = inParallel(eye);
        rays.positionMm *= 3.0;  // which changes nothing that is seen
        const CameraPath path{{{.atS = 0.0, .camera = rays}, {.atS = 2.0, .camera = eye}}};
        EXPECT_EQ(cameraAt(path, 0.0), rays);
        EXPECT_FALSE(isParallel(cameraAt(path, 1.0))) << isRolled;
        EXPECT_NEAR(heightAtTargetMm(cameraAt(path, 1.0)), heightAtTargetMm(eye), 1e-6) << isRolled;
    }
}

// On turntables, as a window's are.
CameraPath wayThrough(const std::vector<OrbitCamera>& places) {
    CameraPath path;
    for (const OrbitCamera& place : places)
        path.stops.push_back({.atS = 2.0 * double(path.stops.size()), .camera = toCamera(place)});
    return path;
}

TEST(SmoothCameraPath, GoesThroughItsStopsWithoutACorner) {
    const CameraPath path = wayThrough({{.distanceMm = 500.0, .azimuthDeg = 0.0, .elevationDeg = 0.0},
                                        {.distanceMm = 400.0, .azimuthDeg = 60.0, .elevationDeg = 30.0},
                                        {.distanceMm = 900.0, .azimuthDeg = 80.0, .elevationDeg = 45.0},
                                        {.distanceMm = 900.0, .azimuthDeg = 170.0, .elevationDeg = 10.0}});
    for (const CameraPath::Stop& stop : path.stops)
        EXPECT_LT(glm::distance(cameraAt(path, stop.atS).positionMm, stop.camera.positionMm), 1e-6);
    // Just before and just after a stop it has the same speed.
    constexpr double kStepS = 1e-4;
    for (const double atS : {2.0, 4.0}) {
        const auto at = [&](double s) { return orbitCameraOf(cameraAt(path, s)).azimuthDeg; };
        const double before = (at(atS) - at(atS - kStepS)) / kStepS;
        const double after = (at(atS + kStepS) - at(atS)) / kStepS;
        EXPECT_NEAR(before, after, 0.05 * std::abs(after) + 0.05) << atS;
    }
    // Between two stops it is nowhere beyond them.
    for (int i = 0; i <= 600; ++i) {
        const double atS = i / 100.0;
        const OrbitCamera now = orbitCameraOf(cameraAt(path, atS));
        const auto from = std::size_t(std::min(atS / 2.0, 2.0));
        const OrbitCamera a = orbitCameraOf(path.stops[from].camera);
        const OrbitCamera b = orbitCameraOf(path.stops[from + 1].camera);
        EXPECT_GE(now.distanceMm, std::min(a.distanceMm, b.distanceMm) - 1e-6) << atS;
        EXPECT_LE(now.distanceMm, std::max(a.distanceMm, b.distanceMm) + 1e-6) << atS;
        EXPECT_GE(now.azimuthDeg, a.azimuthDeg - 1e-6) << atS;
        EXPECT_LE(now.azimuthDeg, b.azimuthDeg + 1e-6) << atS;
    }
}

// Over the poles and behind the patient, where angles jump: the picture never does.
TEST(SmoothCameraPath, NeverFlips) {
    const CameraPath path = wayThrough({{.azimuthDeg = 170.0, .elevationDeg = 60.0},
                                        {.azimuthDeg = -170.0, .elevationDeg = 90.0},
                                        {.azimuthDeg = -130.0, .elevationDeg = -90.0},
                                        {.azimuthDeg = 90.0, .elevationDeg = 0.0}});
    Camera before = cameraAt(path, 0.0);
    for (int i = 1; i <= 6000; ++i) {
        const Camera now = cameraAt(path, i / 1000.0);
        const auto axes = basis(now);
        ASSERT_TRUE(axes.ok()) << i;
        EXPECT_GT(glm::dot(axes->up, basis(before)->up), 0.99) << i;
        EXPECT_GT(glm::dot(axes->right, basis(before)->right), 0.99) << i;
        before = now;
    }
}

TEST(SmoothCameraPath, IsTextAndBack) {
    const CameraPath path =
        wayThrough({{.azimuthDeg = 12.5}, {.targetMm = {1.0 / 3.0, 0.0, 0.0}, .elevationDeg = -20.0}});
    const fs::path file = fs::temp_directory_path() / "macula-path-text.json";
    std::ofstream(file) << toJson(path);
    const auto read = readCameraPath(file);
    fs::remove(file);
    ASSERT_TRUE(read.ok()) << read.error().message;
    ASSERT_EQ(read->stops.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(read->stops[i].atS, path.stops[i].atS);
        EXPECT_EQ(read->stops[i].camera, path.stops[i].camera);
    }
}

}  // namespace
}  // namespace macula::scene
