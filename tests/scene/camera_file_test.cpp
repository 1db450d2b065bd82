#include "scene/camera/camera_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support.h"

namespace macula::scene {
namespace {

class CameraFile : public testing::Test {
  protected:
    Result<Camera> read(const std::string& text) const {
        std::ofstream(folder_ / "camera.json") << text;
        return readCamera(folder_ / "camera.json");
    }

    dicom::test::TemporaryFolder folder_;
};

TEST_F(CameraFile, HoldsACamera) {
    const auto camera = read(
        R"({"positionMm": [1, -2.5, 3], "targetMm": [4, 5, 6], "up": [0, 0, 1], "verticalFovDeg": 12.5})");
    ASSERT_TRUE(camera) << camera.error().message;
    EXPECT_EQ(camera->positionMm, glm::dvec3(1.0, -2.5, 3.0));
    EXPECT_EQ(camera->targetMm, glm::dvec3(4.0, 5.0, 6.0));
    EXPECT_EQ(camera->up, glm::dvec3(0.0, 0.0, 1.0));
    EXPECT_EQ(camera->verticalFovDeg, 12.5);
}

TEST_F(CameraFile, MayHaveParallelRays) {
    const std::string start =
        R"({"positionMm": [1, -2.5, 3], "targetMm": [4, 5, 6], "up": [0, 0, 1], "verticalFovDeg": 12.5)";
    const auto eye = read(start + "}");
    ASSERT_TRUE(eye);
    EXPECT_FALSE(isParallel(*eye));
    EXPECT_FALSE(toJson(*eye).contains("parallelHeightMm"));
    const auto camera = read(start + R"(, "parallelHeightMm": 240.5})");
    ASSERT_TRUE(camera) << camera.error().message;
    EXPECT_EQ(camera->parallelHeightMm, 240.5);
    const auto again = read(toJson(*camera).dump());
    ASSERT_TRUE(again);
    EXPECT_EQ(*again, *camera);
    for (const char* wrong : {"0", "-5", "1e9", "\"high\"", "true"})
        EXPECT_FALSE(read(start + R"(, "parallelHeightMm": )" + wrong + "}")) << wrong;
}

// Nothing is guessed: neither what is missing, nor what a key that is not known may mean.
TEST_F(CameraFile, IsRefusedAsInput) {
    const std::string rest = R"("targetMm": [0, 0, 0], "up": [0, 0, 1])";
    for (const std::string& text : {
             std::string("no JSON"),
             "{" + rest + R"(, "verticalFovDeg": 30})",                               // no position
             R"({"positionMm": [0, 0, 0], )" + rest + R"(, "verticalFovDeg": 30})",   // at its target
             R"({"positionMm": [0, 0, 9], )" + rest + R"(, "verticalFovDeg": 30})",   // along up
             R"({"positionMm": [0, 9, 0], )" + rest + R"(, "verticalFovDeg": 180})",  // too wide
             R"({"positionMm": [0, 9], )" + rest + R"(, "verticalFovDeg": 30})",      // two numbers
             R"({"positionMm": [0, 9, 0], )" + rest + R"(, "verticalFovDeg": 30, "roll": 1})",  // not known
         }) {
        const auto camera = read(text);
        ASSERT_FALSE(camera) << text;
        EXPECT_EQ(camera.error().code, ErrorCode::inputNotUsable) << text;
        EXPECT_NE(camera.error().where.find("camera.json"), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace macula::scene
