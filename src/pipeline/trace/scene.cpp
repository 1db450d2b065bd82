#include "pipeline/trace/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "pipeline/trace/clip_params.h"
#include "pipeline/volume/window.h"
#include "shared/indirect_light.h"

namespace macula::trace {

namespace {

// With single scattering, a deep white wall under a uniform sky of 1 returns (1 - ln 2) / 2 = 0.15 along its
// normal; with all further scattering it would return nearly 1. Three times the light makes the clear look
// about as bright as the cinematic one.
constexpr double kClearGain = 3.0;
// Under the same sky a wall that scatters like a surface returns 2 (ln 2 - 1/2) = 0.39.
constexpr double kSurfaceReturns = 0.39;
constexpr double kCloudReturns = 0.15;
// Where the cache of indirect light is a control variate, a path continues from its first vertex with at
// least this probability: a lower one saves little time, and gives the continuing paths so much weight that
// noise grows.
constexpr double kIndirectLeast = 0.25;

void writeGradientOpacity(const Medium& medium, const Volume& volume, shared::TraceParams& params) {
    params.unitDepthMm = static_cast<float>(medium.unitDepthMm);
    if (medium.gradientOpacity.empty()) return;
    params.gradientLast = static_cast<int>(medium.gradientOpacity.size()) - 1;
    params.gradientScale = static_cast<float>(volume.unitsFromStored().slope / medium.gradientStep);
}

// The extinctions of steep matter are the last in their table (DeviceScene::makeTables).
void writeSteep(const Medium& medium, const Volume& volume, shared::TraceParams& params) {
    if (medium.steep.empty()) return;
    params.steepGradient = static_cast<float>(medium.steepGradientPerMm / volume.unitsFromStored().slope);
    params.steepFirst = static_cast<int>(medium.extinctionPerMm.size() + medium.gradientOpacity.size());
}

void writeSurface(const Medium& medium, const Volume& volume, shared::TraceParams& params) {
    const Surface& surface = medium.surface;
    params.surfaceWeight = static_cast<float>(surface.weight);
    params.surfaceGradient = static_cast<float>(surface.gradientPerMm / volume.unitsFromStored().slope);
    params.surfaceAlpha = static_cast<float>(alphaOf(surface));
    params.surfaceReflectance = static_cast<float>(surface.reflectance);
    std::copy(medium.coat.albedo.begin(), medium.coat.albedo.end(), std::begin(params.coatAlbedo));
    params.coatMean = static_cast<float>(medium.coat.mean);
}

void writeCast(const Settings& settings, const Medium& medium, const Volume& volume,
               shared::TraceParams& params) {
    const EntryMap map = entryMapOf(volume);
    params.entryCount = static_cast<int>(map.tableSize());
    params.paddingEntry = map.padding ? static_cast<float>(map.air - map.low) : -1.0f;
    std::tie(params.windowLow, params.windowHigh) =
        entriesOf(settings.window.value_or(seriesWindow(volume)), volume);
    params.stepsPerEntry = static_cast<float>(volume.unitsFromStored().slope / medium.featureUnits);
    params.ambient = medium.ambient;
    params.diffuse = medium.diffuse;
}

// Voxel coordinates of both volumes have integers at faces: centres are half a voxel on.
void writeAdditions(const Additions& additions, const Volume& volume, shared::TraceParams& params) {
    if (additions.second) {
        const DrawnSecondVolume& second = *additions.second;
        const glm::dmat4 map = secondVoxelFromVoxel(second, volume);
        params.secondOrigin = transformPoint(map, glm::dvec3(-0.5)) + 0.5;
        params.secondFromVoxelX = glm::dvec3(map[0]);
        params.secondFromVoxelY = glm::dvec3(map[1]);
        params.secondFromVoxelZ = glm::dvec3(map[2]);
        params.secondSize = second.volume->size();
        params.secondGrid = brickCount(second.volume->size());
        params.secondEntryCount = static_cast<int>(entryMapOf(*second.volume).tableSize());
        params.secondStepsPerEntry = static_cast<float>(stepsPerEntryOf(second));
    }
    if (additions.tints) {
        params.tintLow = additions.tints->box->low;
        params.tintSize = additions.tints->box->size;
    }
}

// The lights of a panorama or a rig, turned about their own up axis.
void writeLights(const LightFrame frame, const CameraBasis& eye, const Settings& settings,
                 shared::TraceParams& params) {
    glm::dmat3 worldFromLights(glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, -1, 0));  // (L, S, A)
    if (frame == LightFrame::camera) worldFromLights = glm::dmat3(eye.right, eye.up, -eye.forward);
    const double angle = glm::radians(std::remainder(settings.lightRotationDeg, 360.0));
    const glm::dmat3 turn(glm::dvec3(std::cos(angle), 0, -std::sin(angle)), glm::dvec3(0, 1, 0),
                          glm::dvec3(std::sin(angle), 0, std::cos(angle)));
    const glm::dmat3 turned = worldFromLights * turn;
    params.worldFromEnvironmentX = turned[0];
    params.worldFromEnvironmentY = turned[1];
    params.worldFromEnvironmentZ = turned[2];
    const double returned = glm::mix(kCloudReturns, kSurfaceReturns, double(params.surfaceWeight));
    const double gain = settings.look == Look::clear ? kClearGain * kCloudReturns / returned : 1.0;
    params.lightStrength = static_cast<float>(gain * settings.lightStrength);
}

// The cells of the cache of indirect light are cubes in the patient. The shader doubles the smallest one
// until a cell is about as wide as kIndirectCellPixels.
void writeIndirectLight(const Volume& volume, const Environment& environment, const View& view,
                        const Settings& settings, const FoveaInPlane& fovea, shared::TraceParams& params) {
    const glm::dvec3 spacingMm = volume.spacingMm();
    const double smallestMm =
        double(shared::kIndirectLeastVoxels) * std::min({spacingMm.x, spacingMm.y, spacingMm.z});
    params.indirectCellsPerVoxel = spacingMm / smallestMm;
    const double pixelAtOne = 2.0 * fovea.halfSize.y / double(view.height);
    const double atDistance = fovea.parallelMm > 0.0 ? fovea.parallelMm / smallestMm : 1.0;
    params.indirectWidth = static_cast<float>(double(shared::kIndirectCellPixels) * pixelAtOne * atDistance);
    const double unit =
        environment.meanLuminance() * double(params.lightStrength) / double(shared::kIndirectUnitsOfMean);
    params.indirectUnit = std::max(static_cast<float>(unit), std::numeric_limits<float>::min());
    params.indirectLeast =
        settings.indirect == Indirect::corrected ? static_cast<float>(kIndirectLeast) : 0.0f;
    params.indirectStride = indirectStride(view.width, view.height);
}

Result<void> checkSettings(const Settings& settings) {
    const auto fail = [](Text message, Text hint) {
        return Error{ErrorCode::usage, std::move(message), {}, std::move(hint)};
    };
    if (settings.bounces < 1 || settings.bounces > kMaxBounces)
        return fail(Text("{} bounces cannot be traced.", settings.bounces),
                    Text("Choose 1 to {}.", kMaxBounces));
    if (!(settings.exposure > 0.0 && settings.exposure <= kMaxGain))
        return fail(Text("The exposure is not usable."),
                    Text("Choose a number above 0, up to {}.", kMaxGain));
    if (!(settings.lightStrength >= 0.0 && settings.lightStrength <= kMaxGain))
        return fail(Text("The strength of the lights is not usable."),
                    Text("Choose a number from 0 to {}.", kMaxGain));
    if (!std::isfinite(settings.lightRotationDeg))
        return fail(Text("The rotation of the lights is not usable."), Text("Choose an angle in degrees."));
    if (settings.window && !(settings.window->width > 0.0 && std::isfinite(settings.window->width) &&
                             std::isfinite(settings.window->center)))
        return fail(Text("The window is not usable."), Text("Give a centre, and a width above 0."));
    return {};
}

Result<void> check(const Lens& lens) {
    if (!(lens.diameterMm >= 0.0 && lens.diameterMm <= kMostLensMm))
        return Error{ErrorCode::usage,
                     Text("The diameter of the lens is not usable."),
                     {},
                     Text("Choose a number from 0 to {} mm.", kMostLensMm)};
    if (lens.diameterMm > 0.0 && !(lens.focusMm > 0.0 && lens.focusMm <= kMostFocusMm))
        return Error{ErrorCode::usage,
                     Text("The distance of what is sharp is not usable."),
                     {},
                     Text("Choose a number above 0, up to {} mm.", kMostFocusMm)};
    return {};
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
    fovea.parallelMm = view.camera.parallelHeightMm / (2.0 * fovea.halfSize.y);
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
    if (isParallel(view.camera))
        return Error{
            ErrorCode::usage, Text("A parallel view has no fovea."), {}, Text("Trace all of the picture.")};
    const glm::dvec2 inPlane = gaze * foveaInPlane(view).halfSize;
    View window{.camera = view.camera, .width = pixels, .height = pixels};
    window.camera.targetMm =
        view.camera.positionMm + (eye.forward + eye.right * inPlane.x + eye.up * inPlane.y) *
                                     glm::length(view.camera.targetMm - view.camera.positionMm);
    window.camera.verticalFovDeg = fieldDeg;
    MACULA_TRY([[maybe_unused]] const CameraBasis usable, basis(window.camera));
    return window;
}

int indirectStride(int width, int height) {
    const auto columnsOf = [](int pixels, int stride) { return (pixels + stride - 1) / stride; };
    int stride = 1;
    while (std::int64_t(columnsOf(width, stride)) * columnsOf(height, stride) >
           std::int64_t(shared::kIndirectMostRecords))
        ++stride;
    return stride;
}

Result<shared::TraceParams> makeTraceParams(const Volume& volume, const Medium& medium,
                                            const Environment& environment, const View& view,
                                            const Settings& settings, const Clip& clip,
                                            const Additions& additions) {
    MACULA_TRY_VOID(validate(clip));
    MACULA_TRY(const CameraBasis eye, basis(view.camera));
    if (view.width < 1 || view.height < 1 || view.width > kMaxPictureSide || view.height > kMaxPictureSide) {
        return Error{ErrorCode::usage,
                     Text("A picture of {} x {} pixels cannot be made.", view.width, view.height),
                     {},
                     Text("Choose a size from 1 to {} on each side.", kMaxPictureSide)};
    }
    MACULA_TRY_VOID(checkSettings(settings));
    if (view.foveation && !isUsable(*view.foveation)) {
        return Error{
            ErrorCode::usage,
            Text("The foveation is not usable."),
            {},
            Text(
                "Give a gaze inside the picture, a field above 0 and below 170 degrees, and 1 to 16 times.")};
    }
    MACULA_TRY_VOID(check(view.lens));
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
    writeSurface(medium, volume, params);
    writeLights(environment.frame(), eye, settings, params);
    params.volumeSize = volume.size();
    params.gridSize = medium.gridSize;
    params.imageSize = {view.width, view.height};
    params.environmentSize = {environment.width(), environment.height()};
    params.bounces = verticesOf(settings);
    params.seed = settings.seed;
    params.anisotropy = medium.anisotropy;
    writeClip(clip, volume, params);
    writeGradientOpacity(medium, volume, params);
    writeSteep(medium, volume, params);
    writeCast(settings, medium, volume, params);
    writeAdditions(additions, volume, params);
    params.exposure = static_cast<float>(settings.exposure);
    params.keepsHue = settings.toneMap == ToneMap::hue ? 1 : 0;
    params.planeHalfSize = fovea.halfSize;
    params.gaze = fovea.gaze;
    params.foveaRadius = static_cast<float>(fovea.radius);
    params.foveaMagnification = static_cast<float>(fovea.magnification);
    params.parallelMm = static_cast<float>(fovea.parallelMm);
    params.lensRadiusMm = static_cast<float>(0.5 * view.lens.diameterMm);
    params.lensFocusMm = static_cast<float>(view.lens.focusMm);
    writeIndirectLight(volume, environment, view, settings, fovea, params);
    return params;
}

}  // namespace macula::trace
