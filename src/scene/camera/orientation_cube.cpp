#include "scene/camera/orientation_cube.h"

#include <cmath>

namespace macula::scene {

namespace {

constexpr std::array kSides{ViewDirection::anterior, ViewDirection::posterior, ViewDirection::left,
                            ViewDirection::right,    ViewDirection::superior,  ViewDirection::inferior};
constexpr double kLeastFacing = 0.01;  // a face that is seen flatter is a line

}  // namespace

std::vector<CubeFace> facesSeen(const CameraBasis& axes) {
    const auto inPicture = [&](const glm::dvec3& v) {
        return glm::dvec2(glm::dot(v, axes.right), -glm::dot(v, axes.up));
    };
    std::vector<CubeFace> faces;
    for (const ViewDirection side : kSides) {
        // The side as seen by a viewer who faces it, so that no letter is ever mirrored.
        const CameraBasis seen = standardBasis(side);
        const double facing = glm::dot(seen.forward, axes.forward);
        if (!(facing > kLeastFacing)) continue;
        CubeFace face{.side = side, .letter = orientationLetters(-seen.forward), .corners = {}};
        face.middle = inPicture(-seen.forward);
        face.right = inPicture(seen.right);
        face.down = inPicture(-seen.up);
        face.corners = {face.middle - face.right - face.down, face.middle + face.right - face.down,
                        face.middle + face.right + face.down, face.middle - face.right + face.down};
        face.facing = facing;
        faces.push_back(face);
    }
    return faces;
}

std::optional<ViewDirection> faceAt(const CameraBasis& axes, const glm::dvec2& place) {
    for (const CubeFace& face : facesSeen(axes)) {
        const glm::dvec2 from = place - face.middle;
        const double area = face.right.x * face.down.y - face.right.y * face.down.x;
        const double right = (from.x * face.down.y - from.y * face.down.x) / area;
        const double down = (face.right.x * from.y - face.right.y * from.x) / area;
        if (std::abs(right) <= 1.0 && std::abs(down) <= 1.0) return face.side;
    }
    return std::nullopt;
}

}  // namespace macula::scene
