// A cube with a letter on each side, turned as the patient is in the picture.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/camera.h"
#include "base/frames.h"

namespace macula::app {

// In halves of an edge of the cube from its middle, x to the right, y down. The cube is drawn with parallel
// rays, whatever the picture is drawn with.
struct CubeFace {
    ViewDirection side = ViewDirection::anterior;
    std::string letter;                 // of that side of the patient: A, P, L, R, S, I
    std::array<glm::dvec2, 4> corners;  // top left, top right, bottom right, bottom left of its letter
    glm::dvec2 middle{0.0};
    glm::dvec2 right{0.0};  // where the letter's right is; its edge is twice as long
    glm::dvec2 down{0.0};
    double facing = 0.0;  // 1: straight to who looks; above 0
};

// How far any corner is from the middle, at most.
inline constexpr double kCubeReach = 1.7320508075688772;

// One to three, those that are seen.
std::vector<CubeFace> facesSeen(const CameraBasis& axes);

// The face there; nothing beside the cube.
std::optional<ViewDirection> faceAt(const CameraBasis& axes, const glm::dvec2& place);

}  // namespace macula::app
