#include "app/camera/camera_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace macula::app {
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
        return path.error().message + " " + path.error().hint;
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

}  // namespace
}  // namespace macula::app
