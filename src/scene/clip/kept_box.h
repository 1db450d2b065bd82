// The box that a clip leaves of a volume, by its six faces. World frame: patient LPS, mm.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "base/frames.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip_json.h"

namespace macula::scene {

// As in StudyState::clip. Nothing: all of the volume is shown.
using OptionalClip = std::optional<ClipPreset>;

// Named after the side of the patient that it faces; low and high face of x, of y, of z.
enum class Face { right, left, anterior, posterior, inferior, superior };

inline constexpr std::array kFaces{Face::right,     Face::left,     Face::anterior,
                                   Face::posterior, Face::inferior, Face::superior};

constexpr int axisOf(Face face) {
    return int(face) / 2;
}
constexpr bool isHigh(Face face) {
    return int(face) % 2 == 1;
}
constexpr Face faceOf(int axis, bool high) {
    return kFaces.at(2 * std::size_t(axis) + (high ? 1 : 0));
}
std::string_view nameOf(Face face);  // "right"
char letterOf(Face face);            // 'R'

double faceMm(const Box& box, Face face);
void setFaceMm(Box& box, Face face, double mm);

// Whether the plane is perpendicular to one of the patient's axes, and so counts as a face.
bool isAlongAxis(const HalfSpace& plane);
// Whether the clip keeps the inside of a box along the patient's axes.
bool keepsBox(const Clip& clip);

// The extent of one voxel along each of the patient's axes, at most that of the volume.
glm::dvec3 voxelExtentMm(const Volume& volume);

// The part of the volume's box (Volume::worldBox) that the box and planes along the patient's axes leave.
// Ignores oblique planes, removed or turned boxes, corners and balls. usage when nothing is left.
Result<Box> keptBox(const OptionalClip& clip, const Volume& volume);

}  // namespace macula::scene
