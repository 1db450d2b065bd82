#include "scene/presentation/presentation_of_state.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "pipeline/volume/volume_fit.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/lights_choice.h"
#include "scene/choice/preset_choice.h"
#include "scene/clip/eye_cut.h"
#include "scene/drawing/drawing_of.h"
#include "scene/drawing/projection_windows.h"
#include "scene/lights/light_direction.h"
#include "scene/lights/light_meter.h"
#include "scene/presentation/palette_of_transfer.h"
#include "scene/presentation/voxel_axes.h"
#include "scene/second/second_curve.h"

namespace macula::scene {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr const char* kCustom = "custom";
constexpr std::size_t kLongestOwnState = 200000;

dicom::PresentedView viewOf(const Camera& seen, const CameraBasis& axes, const Volume& volume,
                            double aspect) {
    // Stands before the volume, because near planes must lie in front of the viewpoint.
    const Camera camera = standingBefore(seen, volume.worldBox());
    double nearest = 1e9;
    double farthest = 0.0;
    for (const glm::dvec3& corner : cornersOf(volume.worldBox())) {
        const double depth = glm::dot(corner - camera.positionMm, axes.forward);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    constexpr double kNearestMm = 0.1;
    constexpr double kMarginMm = 1.0;
    dicom::PresentedView view{
        .positionMm = camera.positionMm, .lookAtMm = camera.targetMm, .up = camera.up, .field = {}};
    view.field.nearMm = std::max(kNearestMm, nearest - kMarginMm);
    view.field.farMm = std::max(view.field.nearMm, farthest) + kMarginMm;
    if (isParallel(camera)) {
        view.projection = dicom::Projection::orthographic;
        view.field.topMm = 0.5 * camera.parallelHeightMm;
    } else {
        view.field.topMm = view.field.farMm * std::tan(0.5 * kDegree * camera.verticalFovDeg);
    }
    view.field.bottomMm = -view.field.topMm;
    view.field.rightMm = view.field.topMm * aspect;
    view.field.leftMm = -view.field.rightMm;
    return view;
}

// The strongest light, and all others as ambient light, by the irradiance of a surface that faces them.
dicom::PresentedShading shadingOf(const trace::LightRig& rig, double rotationDeg, const CameraBasis& axes) {
    double all = brightnessOf(rig.ambientZenith + 2.0 * rig.ambientHorizon + rig.ambientNadir) / 4.0;
    double strongest = 0.0;
    dicom::PresentedShading shading{.ambient = 1.0, .shininess = {}, .lightDirection = axes.forward};
    for (const trace::SoftLight& light : rig.lights) {
        const double size = std::sin(kDegree * std::min(light.angularRadiusDeg, 90.0));
        const double gives = light.radiance * brightnessOf(light.colour) * size * size;
        all += gives;
        if (gives <= strongest) continue;
        strongest = gives;
        shading.lightDirection = -directionTo(light, {rig.frame, axes, rotationDeg});
    }
    if (strongest > 0.0) {
        shading.diffuse = strongest / all;
        shading.ambient = 1.0 - shading.diffuse;
    }
    return shading;
}

Result<trace::LightRig> lightsOf(const StudyState& state) {
    if (state.lights) return *state.lights;
    MACULA_TRY(const std::vector<trace::LightRig> all, builtInLights());
    const auto usual = std::ranges::find(all, defaultLightsFor(state.settings.look), &trace::LightRig::name);
    return usual != all.end() ? *usual : trace::LightRig{};
}

Result<void> say(SaidState& said, const StudyState& state, const Volume& volume, const CameraBasis& axes) {
    const trace::Settings settings = settingsOf(state, SeriesWindows(), &volume);
    dicom::VolumePresentation& p = said.presentation;
    if (settings.look == trace::Look::mip || settings.look == trace::Look::minip) {
        p.method = settings.look == trace::Look::mip ? dicom::RenderingMethod::maximum
                                                     : dicom::RenderingMethod::minimum;
        p.palette.values = valuesSeen(*settings.window);
        if (settings.window->function == "SIGMOID")
            said.leftOut.push_back(Text("The window is a curve; others get a straight one."));
        return {};
    }
    const TransferFunction function = fitted(*state.preset, volume);
    p.palette = paletteOf(function);
    p.samplingStepMm = layerMmOf(function);
    if (settings.look == trace::Look::average)
        said.leftOut.push_back(Text("Others cannot show an average, and show the preset instead."));
    if (usesGradientOpacity(function))
        said.leftOut.push_back(Text("Opacities that depend on edges (gradients) are for Macula alone."));
    if (usesSteepCurves(function))
        said.leftOut.push_back(
            Text("Others know no steep matter: they show what is halfway between flat and steep."));
    if (trace::isPathTraced(settings.look)) {
        MACULA_TRY(const trace::LightRig lights, lightsOf(state));
        p.shading = shadingOf(lights, settings.lightRotationDeg, axes);
        said.leftOut.push_back(
            Text("Others have no path tracing: of the lights they get the strongest, and how bright the rest "
                 "is."));
    } else if (settings.shading == trace::Shading::headlight) {
        const auto part = [](double value) { return std::clamp(value, 0.0, 1.0); };
        p.shading = {.ambient = part(function.lighting.ambient),
                     .diffuse = part(function.lighting.diffuse),
                     .shininess = {},
                     .lightDirection = axes.forward};
    }
    return {};
}

dicom::CroppingPlane croppingOf(const HalfSpace& kept) {
    return {.outward = -kept.normal, .offsetMm = -kept.offsetMm};
}

void sayClip(SaidState& said, const StudyState& state, const Volume& volume) {
    dicom::Cropping& cropping = said.presentation.cropping;
    if (state.leavesTableOut) said.leftOut.push_back(Text("Others show the table, which is left out here."));
    if (!in3dOf(state.segmentations).empty())
        said.leftOut.push_back(Text("Others show segments that are hidden here."));
    if (!colouredIn3dOf(state.segmentations).empty())
        said.leftOut.push_back(Text("Others show no colours of segments."));
    if (state.secondVolume && isSecondIn3d(*state.secondVolume))
        said.leftOut.push_back(Text("Others show the study without the second volume."));
    if (!state.cuts.scissors.empty())
        said.leftOut.push_back(Text("Others show what is cut off with scissors here."));
    const Clip clip = clipFor(state.clip, state.cuts, volume);
    if (clip.box && clip.ofBox == Keep::inside) {
        if (clip.box->axes == glm::dmat3(1.0) && isAlongPatient(volume)) {
            cropping.boxes.push_back(
                {clip.box->centreMm - clip.box->halfSizeMm, clip.box->centreMm + clip.box->halfSizeMm});
        } else {
            for (const HalfSpace& side : sidesOf(*clip.box)) cropping.planes.push_back(croppingOf(side));
        }
    }
    for (const HalfSpace& plane : clip.planes) cropping.planes.push_back(croppingOf(plane));
    bool isCutOut = false;
    forEachShape(clip, [&](const ClipShape auto& shape, Keep keep) {
        const bool canBeSaid = shape.kKey == OrientedBox::kKey || shape.kKey == HalfSpace::kKey;
        isCutOut = isCutOut || !canBeSaid || keep == Keep::outside;
    });
    if (isCutOut) said.leftOut.push_back(Text("Others show boxes, corners and balls that are cut out here."));
    if (clip.removedCastsShadow || clip.greyFaces)
        said.leftOut.push_back(Text("Grey faces and shadows of what is cut off are for Macula alone."));
}

constexpr const char* kNobodys = "nobody's";  // in place of the digest of a series

void removeNames(std::shared_ptr<const TransferFunction>& named) {
    if (!named) return;
    TransferFunction preset = *named;
    if (publicPresetName(preset) == kCustom) {
        preset.name = kCustom;
        preset.title = "Custom";
        preset.source.clear();
    }
    preset.document.clear();
    named = std::make_shared<const TransferFunction>(std::move(preset));
}

// Names and texts that a person typed may identify the patient, and so may the digest of a UID, as a UID can
// be guessed.
StudyState withoutNames(StudyState state) {
    removeNames(state.preset);
    if (state.secondVolume) removeNames(state.secondVolume->preset);
    if (state.clip && publicClipName(*state.clip) == kCustom) {
        state.clip->name = kCustom;
        state.clip->title = "Custom";
    }
    if (state.lights && publicLightsName(*state.lights) == kCustom) {
        trace::LightRig lights = *state.lights;
        lights.name = kCustom;
        lights.title = "Custom";
        state.lights = std::make_shared<const trace::LightRig>(std::move(lights));
    }
    state.seriesDigest.clear();  // readers use the series that the object refers to
    if (state.secondVolume) {
        state.secondVolume->seriesDigest = kNobodys;
        state.secondVolume->volumeKey.clear();
    }
    state.segmentations.clear();
    for (slices::Measurement& measurement : state.measurements) measurement.label.clear();
    state.namedClips.clear();
    state.otherKeys.clear();
    return state;
}

std::string ownStateOf(const StudyState& state, bool isDeidentified) {
    const std::string text = toJson(isDeidentified ? withoutNames(state) : state);
    return nlohmann::ordered_json::parse(text).dump(-1, ' ', true);  // in ASCII
}

}  // namespace

Result<SaidState> presentationOf(const StudyState& state, const Volume& volume, double aspectWidthOverHeight,
                                 bool isDeidentified) {
    if (!state.preset || !state.camera || !(aspectWidthOverHeight > 0.0))
        return Error{ErrorCode::usage,
                     Text("There is no picture yet to make a presentation state of."),
                     {},
                     Text("Wait until the study is shown.")};
    MACULA_TRY(const CameraBasis axes, basis(*state.camera));
    SaidState said;
    said.presentation.label = "MACULA 3D";
    said.presentation.description = "Macula 3D view, not for primary diagnosis";
    said.presentation.view = viewOf(*state.camera, axes, volume, aspectWidthOverHeight);
    MACULA_TRY_VOID(say(said, state, volume, axes));
    sayClip(said, state, volume);
    said.presentation.ownState = ownStateOf(state, isDeidentified);
    if (isDeidentified && (state.secondVolume || !state.segmentations.empty()))
        said.leftOut.push_back(
            Text("Without patient and study, the second volume and segmentations are not found again."));
    if (said.presentation.ownState.size() > kLongestOwnState) {
        said.presentation.ownState.clear();
        said.leftOut.push_back(
            Text("The view is too large to be kept as a whole: Macula too shows only what others show."));
    }
    return said;
}

}  // namespace macula::scene
