#include "pipeline/trace/scene.h"

#include <algorithm>
#include <cmath>

namespace macula::trace {

Result<shared::TraceParams> makeTraceParams(const Volume& volume, const Medium& medium,
                                            const Environment& environment, const View& view,
                                            const Settings& settings) {
    MACULA_TRY(const CameraBasis eye, basis(view.camera));
    if (view.width < 1 || view.height < 1 || view.width > kMaxPictureSide || view.height > kMaxPictureSide) {
        return Error{ErrorCode::usage,
                     fmt::format("A picture of {} x {} pixels cannot be made.", view.width, view.height),
                     {},
                     fmt::format("Choose a size from 1 to {} on each side.", kMaxPictureSide)};
    }
    if (settings.bounces < 1 || settings.bounces > kMaxBounces) {
        return Error{ErrorCode::usage,
                     fmt::format("{} bounces cannot be traced.", settings.bounces),
                     {},
                     fmt::format("Choose 1 to {}.", kMaxBounces)};
    }
    const glm::dmat4 voxelFromWorld = glm::inverse(volume.worldFromVoxel());
    const double halfHeight = std::tan(glm::radians(view.camera.verticalFovDeg) / 2.0);
    const double halfWidth = halfHeight * double(view.width) / double(view.height);

    shared::TraceParams params{};
    params.originVoxel =
        transformPoint(voxelFromWorld, view.camera.positionMm) + 0.5;  // from centres to faces
    params.right = eye.right * halfWidth;
    params.up = eye.up * halfHeight;
    params.forward = eye.forward;
    params.voxelFromWorldX = glm::dvec3(voxelFromWorld[0]);
    params.voxelFromWorldY = glm::dvec3(voxelFromWorld[1]);
    params.voxelFromWorldZ = glm::dvec3(voxelFromWorld[2]);
    if (environment.frame() == LightFrame::camera) {
        params.worldFromEnvironmentX = eye.right;
        params.worldFromEnvironmentY = eye.up;
        params.worldFromEnvironmentZ = -eye.forward;
    } else {  // (Left, Superior, Anterior)
        params.worldFromEnvironmentX = {1, 0, 0};
        params.worldFromEnvironmentY = {0, 0, 1};
        params.worldFromEnvironmentZ = {0, -1, 0};
    }
    params.volumeSize = volume.size();
    params.gridSize = medium.gridSize;
    params.imageSize = {view.width, view.height};
    params.environmentSize = {environment.width(), environment.height()};
    params.bounces = settings.bounces;
    params.seed = settings.seed;
    params.anisotropy = medium.anisotropy;
    const glm::dvec3 spacing = volume.spacingMm();
    params.marchStepMm = static_cast<float>(0.5 * std::min({spacing.x, spacing.y, spacing.z}));
    return params;
}

}  // namespace macula::trace
