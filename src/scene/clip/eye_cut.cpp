#include "scene/clip/eye_cut.h"

#include <algorithm>
#include <cmath>

namespace macula::scene {

namespace {

// How far the box reaches from its middle along a unit vector.
double reachMm(const Box& box, const glm::dvec3& along) {
    return glm::dot(0.5 * (box.high - box.low), glm::abs(along));
}

}  // namespace

ValueRange eyeCutRangeMm(const glm::dvec3& normal, const Volume& volume) {
    const double reach = reachMm(volume.worldBox(), normal);
    const double voxel = glm::dot(voxelExtentMm(volume), glm::abs(normal));
    return {.low = -reach, .high = std::max(reach - voxel, -reach)};
}

EyeCut at(EyeCut cut, double fromMiddleMm, const Volume& volume) {
    if (!std::isfinite(fromMiddleMm)) return cut;
    const ValueRange range = eyeCutRangeMm(cut.plane.normal, volume);
    cut.fromMiddleMm = fromMiddleMm;
    cut.plane.offsetMm = glm::dot(cut.plane.normal, volume.worldBox().centre()) +
                         std::clamp(fromMiddleMm, range.low, range.high);
    return cut;
}

EyeCut through(EyeCut cut, const glm::dvec3& mm, const Volume& volume) {
    const ValueRange range = eyeCutRangeMm(cut.plane.normal, volume);
    const double fromMiddleMm = glm::dot(cut.plane.normal, mm - volume.worldBox().centre());
    return at(cut, std::clamp(fromMiddleMm, range.low, range.high), volume);
}

Result<EyeCut> eyeCut(const Camera& camera, double fromMiddleMm, bool followsCamera, const Volume& volume) {
    MACULA_TRY(const CameraBasis axes, basis(camera));
    if (!std::isfinite(fromMiddleMm))
        return Error{
            ErrorCode::usage, Text("The depth of the cut is not a number."), {}, Text("Give it in mm.")};
    return at({.plane = {.normal = axes.forward, .offsetMm = 0.0},
               .fromMiddleMm = 0.0,
               .followsCamera = followsCamera},
              fromMiddleMm, volume);
}

bool hasRoomForEyeCut(const OptionalClip& clip) {
    return !clip || clip->clip.planes.size() < Clip::kMostPlanes;
}

Clip clipFor(const OptionalClip& clip, const Cuts& cuts, const Volume& volume) {
    Clip all;
    if (clip) all = macula::clipFor(*clip, volume);
    if (cuts.eye && hasRoomForEyeCut(clip)) all.planes.push_back(cuts.eye->plane);
    return all;
}

}  // namespace macula::scene
