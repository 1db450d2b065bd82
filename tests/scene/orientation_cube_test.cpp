#include "scene/camera/orientation_cube.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/camera/orbit_camera.h"

namespace macula::scene {
namespace {

CameraBasis axesOf(double azimuthDeg, double elevationDeg, double rollDeg) {
    OrbitCamera camera{.azimuthDeg = azimuthDeg, .elevationDeg = elevationDeg, .rollDeg = rollDeg};
    return *basis(toCamera(camera));
}

TEST(OrientationCube, FromTheFrontItShowsAnteriorUpright) {
    const auto faces = facesSeen(axesOf(0, 0, 0));
    ASSERT_EQ(faces.size(), 1u);
    EXPECT_EQ(faces[0].letter, "A");
    EXPECT_EQ(faces[0].side, ViewDirection::anterior);
    EXPECT_NEAR(faces[0].facing, 1.0, 1e-12);
    EXPECT_NEAR(faces[0].right.x, 1.0, 1e-12);
    EXPECT_NEAR(faces[0].down.y, 1.0, 1e-12);
    EXPECT_NEAR(glm::length(faces[0].middle), 0.0, 1e-12);
}

// The patient's left is at the right of a picture from the front, and superior above.
TEST(OrientationCube, SidesLieWhereTheyAreInThePicture) {
    const auto faces = facesSeen(axesOf(25, 20, 0));
    ASSERT_EQ(faces.size(), 3u);
    for (const CubeFace& face : faces) {
        if (face.letter == "L") {
            EXPECT_GT(face.middle.x, 0.3);
        }
        if (face.letter == "S") {
            EXPECT_LT(face.middle.y, -0.3);
        }
        EXPECT_TRUE(face.letter == "A" || face.letter == "L" || face.letter == "S") << face.letter;
    }
}

TEST(OrientationCube, NoLetterIsMirroredAndWhatIsClickedIsWhatIsSeen) {
    for (double azimuth = -180; azimuth < 180; azimuth += 30) {
        for (const double elevation : {-90.0, -45.0, 0.0, 10.0, 90.0}) {
            for (const double roll : {0.0, 50.0, -130.0}) {
                const CameraBasis axes = axesOf(azimuth, elevation, roll);
                const auto faces = facesSeen(axes);
                ASSERT_GE(faces.size(), 1u);
                ASSERT_LE(faces.size(), 3u);
                for (const CubeFace& face : faces) {
                    EXPECT_GT(face.right.x * face.down.y - face.right.y * face.down.x, 0.0);
                    EXPECT_EQ(faceAt(axes, face.middle), face.side);
                    EXPECT_EQ(faceAt(axes, face.middle + 0.9 * face.right - 0.9 * face.down), face.side);
                    EXPECT_GT(face.facing, 0.0);
                    for (const glm::dvec2& corner : face.corners)
                        EXPECT_LE(glm::length(corner), kCubeReach + 1e-9);
                }
                EXPECT_EQ(faceAt(axes, {1.8, 0.0}), std::nullopt);
                EXPECT_EQ(faceAt(axes, {std::nan(""), 0.0}), std::nullopt);
            }
        }
    }
}

// A camera that looks from the side that was clicked sees that face alone.
TEST(OrientationCube, LookingFromAFaceShowsItAlone) {
    for (const auto side : {ViewDirection::anterior, ViewDirection::posterior, ViewDirection::left,
                            ViewDirection::right, ViewDirection::superior, ViewDirection::inferior}) {
        const auto faces = facesSeen(*basis(toCamera(turnedTo({}, side))));
        ASSERT_EQ(faces.size(), 1u);
        EXPECT_EQ(faces[0].side, side);
        EXPECT_NEAR(faces[0].down.y, 1.0, 1e-9) << "upright";
    }
}

}  // namespace
}  // namespace macula::scene
