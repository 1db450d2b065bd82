#include "scene/clip/kept_box.h"

#include <algorithm>

namespace macula::scene {

namespace {

constexpr std::array<std::string_view, kFaces.size()> kNames{"right",     "left",     "anterior",
                                                             "posterior", "inferior", "superior"};
constexpr std::string_view kLetters = "RLAPIS";

}  // namespace

std::string_view nameOf(Face face) {
    return kNames.at(std::size_t(face));
}

char letterOf(Face face) {
    return kLetters.at(std::size_t(face));
}

double faceMm(const Box& box, Face face) {
    return (isHigh(face) ? box.high : box.low)[axisOf(face)];
}

void setFaceMm(Box& box, Face face, double mm) {
    (isHigh(face) ? box.high : box.low)[axisOf(face)] = mm;
}

bool isAlongAxis(const HalfSpace& plane) {
    const glm::dvec3& n = plane.normal;
    return int(n.x != 0.0) + int(n.y != 0.0) + int(n.z != 0.0) == 1;
}

bool keepsBox(const Clip& clip) {
    return clip.box && clip.ofBox == Keep::inside && clip.box->axes == glm::dmat3(1.0);
}

glm::dvec3 voxelExtentMm(const Volume& volume) {
    const glm::dmat4& m = volume.worldFromVoxel();
    const glm::dvec3 extent =
        glm::abs(glm::dvec3(m[0])) + glm::abs(glm::dvec3(m[1])) + glm::abs(glm::dvec3(m[2]));
    const Box all = volume.worldBox();
    return glm::min(extent, all.high - all.low);
}

Result<Box> keptBox(const OptionalClip& clip, const Volume& volume) {
    Box kept = volume.worldBox();
    if (!clip) return kept;
    const Clip inMm = clipFor(*clip, volume);
    if (keepsBox(inMm)) {
        kept.low = glm::max(kept.low, inMm.box->centreMm - inMm.box->halfSizeMm);
        kept.high = glm::min(kept.high, inMm.box->centreMm + inMm.box->halfSizeMm);
    }
    for (const HalfSpace& plane : inMm.planes) {
        if (!isAlongAxis(plane)) continue;
        const int axis = plane.normal.x != 0.0 ? 0 : plane.normal.y != 0.0 ? 1 : 2;
        const double atMm = plane.offsetMm / plane.normal[axis];
        if (plane.normal[axis] > 0.0) {
            kept.low[axis] = std::max(kept.low[axis], atMm);
        } else {
            kept.high[axis] = std::min(kept.high[axis], atMm);
        }
    }
    if (!glm::all(glm::lessThan(kept.low, kept.high)))
        return Error{ErrorCode::usage,
                     Text("The clip leaves nothing of this volume."),
                     {},
                     Text("Begin again without a clip.")};
    return kept;
}

}  // namespace macula::scene
