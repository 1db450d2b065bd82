// A cube with a letter on each side, turned as the patient is in the picture.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/camera.h"
#include "base/frames.h"

namespace macula::scene {

// A visible face, in halves of an edge of the cube from its middle, x to the right, y down. The projection of
// the cube is always parallel.
struct CubeFace {
    ViewDirection side = ViewDirection::anterior;
    std::string letter;                 // names the side of the patient: A, P, L, R, S, I
    std::array<glm::dvec2, 4> corners;  // top left, top right, bottom right, bottom left of its letter
    glm::dvec2 middle{0.0};
    glm::dvec2 right{0.0};  // from the middle to the right edge, as the letter reads
    glm::dvec2 down{0.0};
    double facing = 0.0;  // cosine, above 0; 1: straight to the viewer
};

// The largest distance of a corner from the middle: the square root of 3.
inline constexpr double kCubeReach = 1.7320508075688772;

// The visible faces, one to three.
std::vector<CubeFace> facesSeen(const CameraBasis& axes);

// The face at `place`, or nothing outside the cube.
std::optional<ViewDirection> faceAt(const CameraBasis& axes, const glm::dvec2& place);

}  // namespace macula::scene
