#include "pipeline/trace/scene.h"

#include <algorithm>
#include <cmath>

namespace macula::trace {

namespace {

// Voxel coordinates have integers at faces: centres are half a voxel on.
glm::vec4 planeInVoxels(const HalfSpace& side, const glm::dmat4& worldFromVoxel) {
    const glm::dvec3 origin = transformPoint(worldFromVoxel, glm::dvec3(-0.5));
    return glm::dvec4(glm::transpose(glm::dmat3(worldFromVoxel)) * side.normal,
                      glm::dot(side.normal, origin) - side.offsetMm);
}

void writeClip(const Clip& clip, const Volume& volume, shared::TraceParams& params) {
    const glm::dmat4& worldFromVoxel = volume.worldFromVoxel();
    int next = 0;
    const auto add = [&](const auto& sides) {
        for (const HalfSpace& side : sides) params.clipPlanes[next++] = planeInVoxels(side, worldFromVoxel);
        return static_cast<int>(sides.size());
    };
    params.clipKeepCount = add(clip.planes);
    if (clip.box && clip.ofBox == Keep::inside) params.clipKeepCount += add(sidesOf(*clip.box));
    if (clip.box && clip.ofBox == Keep::outside) params.clipBoxCount = add(sidesOf(*clip.box));
    if (clip.cut) params.clipCornerCount = add(sidesOf(*clip.cut));
    if (clip.ball) {
        params.clipBall = clip.ofBall == Keep::inside ? shared::kClipKeepBall : shared::kClipCutBall;
        params.clipBallCentre = transformPoint(glm::inverse(worldFromVoxel), clip.ball->centreMm) + 0.5;
        params.clipBallX = glm::dvec3(worldFromVoxel[0]) / clip.ball->radiusMm;
        params.clipBallY = glm::dvec3(worldFromVoxel[1]) / clip.ball->radiusMm;
        params.clipBallZ = glm::dvec3(worldFromVoxel[2]) / clip.ball->radiusMm;
    }
    params.clipShadows = clip.removedCastsShadow ? 1 : 0;
    if (!clip.greyFaces || clip.isNothing()) return;
    // PS3.3 C.11.2.1.2: LINEAR is white one unit before the end of the window.
    const DisplayWindow& window = *clip.greyFaces;
    const bool isExact = window.width <= 1.0 || window.function == "LINEAR_EXACT";
    const double low = window.center - window.width / 2.0;
    const double high = window.center + window.width / 2.0 - (isExact ? 0.0 : 1.0);
    const UnitsFromStored units = volume.unitsFromStored();
    const int firstStored = entryMapOf(volume).low;
    const auto entry = [&](double value) { return (value - units.intercept) / units.slope - firstStored; };
    params.greyFaces = 1;
    params.greyLow = static_cast<float>(entry(low));
    params.greyHigh = static_cast<float>(std::max(entry(high), entry(low) + 1e-3));
}

bool isUsable(const Foveation& foveation) {
    return std::abs(foveation.gaze.x) <= 1.0 && std::abs(foveation.gaze.y) <= 1.0 &&
           foveation.fieldDeg > 0.0 && foveation.fieldDeg < 170.0 && foveation.magnification >= 1.0 &&
           foveation.magnification <= 16.0;
}

}  // namespace

FoveaInPlane foveaInPlane(const View& view) {
    FoveaInPlane fovea;
    fovea.halfSize.y = std::tan(glm::radians(view.camera.verticalFovDeg) / 2.0);
    fovea.halfSize.x = fovea.halfSize.y * double(view.width) / double(view.height);
    if (!view.foveation) return fovea;
    // A gaze on the border would leave no room between the fovea and it.
    constexpr double kInside = 0.98;
    constexpr double kMostOfRoom = 0.8;
    fovea.gaze = glm::clamp(view.foveation->gaze, glm::dvec2(-kInside), glm::dvec2(kInside)) * fovea.halfSize;
    const glm::dvec2 room = fovea.halfSize - glm::abs(fovea.gaze);
    fovea.magnification = view.foveation->magnification;
    fovea.radius = std::min(fovea.magnification * std::tan(glm::radians(view.foveation->fieldDeg) / 2.0),
                            kMostOfRoom * std::min(room.x, room.y));
    return fovea;
}

Result<View> fovealWindow(const View& view, const glm::dvec2& gaze, double fieldDeg, int pixels) {
    MACULA_TRY(const CameraBasis eye, basis(view.camera));
    const glm::dvec2 inPlane = gaze * foveaInPlane(view).halfSize;
    View window{.camera = view.camera, .width = pixels, .height = pixels};
    window.camera.targetMm =
        view.camera.positionMm + (eye.forward + eye.right * inPlane.x + eye.up * inPlane.y) *
                                     glm::length(view.camera.targetMm - view.camera.positionMm);
    window.camera.verticalFovDeg = fieldDeg;
    MACULA_TRY([[maybe_unused]] const CameraBasis usable, basis(window.camera));
    return window;
}

Result<shared::TraceParams> makeTraceParams(const Volume& volume, const Medium& medium,
                                            const Environment& environment, const View& view,
                                            const Settings& settings, const Clip& clip) {
    MACULA_TRY_VOID(validate(clip));
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
    if (view.foveation && !isUsable(*view.foveation)) {
        return Error{
            ErrorCode::usage,
            "The foveation is not usable.",
            {},
            "Give a gaze inside the picture, a field above 0 and below 170 degrees, and 1 to 16 times."};
    }
    const glm::dmat4 voxelFromWorld = glm::inverse(volume.worldFromVoxel());
    const FoveaInPlane fovea = foveaInPlane(view);

    shared::TraceParams params{};
    params.originVoxel =
        transformPoint(voxelFromWorld, view.camera.positionMm) + 0.5;  // from centres to faces
    params.right = eye.right * fovea.halfSize.x;
    params.up = eye.up * fovea.halfSize.y;
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
    writeClip(clip, volume, params);
    params.exposure = static_cast<float>(settings.exposure);
    params.planeHalfSize = fovea.halfSize;
    params.gaze = fovea.gaze;
    params.foveaRadius = static_cast<float>(fovea.radius);
    params.foveaMagnification = static_cast<float>(fovea.magnification);
    return params;
}

bool isClipped(const shared::TraceParams& params) {
    return params.clipKeepCount + params.clipBoxCount + params.clipCornerCount > 0 ||
           params.clipBall != shared::kClipNoBall;
}

}  // namespace macula::trace
