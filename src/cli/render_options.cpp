#include "cli/render_options.h"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <cstdint>
#include <map>

#include "cli/addition_options.h"
#include "cli/shared/name_option.h"
#include "cli/shared/number_range.h"
#include "cli/shared/output_options.h"
#include "cli/shared/study_options.h"
#include "pipeline/trace/settings.h"
#include "scene/state/parameters.h"

namespace macula::cli {

namespace {

std::map<std::string, int> looksByName() {
    std::map<std::string, int> looks;
    for (const trace::LookTraits& look : trace::kLooks) looks.emplace(look.name, static_cast<int>(look.look));
    return looks;
}

std::string lookNames() {
    std::string names;
    for (const trace::LookTraits& look : trace::kLooks)
        names += (names.empty() ? "" : "|") + std::string(look.name);
    return names;
}

std::string helpOf(const scene::Parameter& p) {
    return fmt::format("{} (default: {:g})", p.does, p.fallback());
}

// What is drawn, and where to.
void addInput(CLI::App& command, pictures::RenderRequest& o) {
    command.add_option(
        "PATH", o.path,
        "Folder, ZIP, tar or ISO of DICOM files, NIfTI, NRRD, MetaImage, or phantom: (default)");
    command
        .add_option("-o,--output", o.output,
                    "Picture to write: OUT.png for display, OUT.exr for linear light and depth")
        ->required();
    addJoin(command, o.how);
    command.add_option("--series", o.series,
                       "Place in the list of macula info, or series UID (default: the best)");
    addSavedView(command, o.state.savedView);
    command
        .add_option(
            "--presentation-state", o.state.presentation,
            "DICOM presentation state of this series: drawn as it says, but for what is given besides")
        ->option_text("FILE")
        ->excludes("--session");
    command.add_option(
        "--preset", o.state.preset,
        "Name or number from macula presets, or preset file (default: by what the series shows)");
    command.add_flag("--fit", o.state.fit,
                     "Stretch the preset's range to the series, for MR: see docs/presets.md");
}

// Options of the camera and the size of the picture.
void addCamera(CLI::App& command, pictures::RenderRequest& o) {
    auto* view =
        command
            .add_option("--view", o.state.view,
                        "Where the viewer stands (default: by what was scanned, see docs/command.md)")
            ->transform(asViewDirection())
            ->option_text(kViewDirectionNames);
    command
        .add_option("--camera", o.state.camera,
                    "JSON file: positionMm, targetMm, up, verticalFovDeg; patient LPS mm")
        ->excludes(view);
    command.add_flag("--parallel", o.state.isParallel,
                     "Parallel rays: the same mm per pixel at every depth; of --camera as at its target");
    command
        .add_option("--fov", o.state.fovDeg,
                    "Vertical field of view in degrees (default: that of --camera, or 30)")
        ->check(between(0.1, 170.0));
    command.add_option("--size", o.size, "Picture size in pixels (default: 768x768)")->option_text("WxH");
    command
        .add_option("--background", o.background,
                    "Behind the patient: black, white, grey, #rrggbb, or transparent (default: black)")
        ->option_text("COLOUR");
}

// How.
void addLook(CLI::App& command, pictures::RenderRequest& o) {
    command.add_option("--look", o.state.look, "How it is drawn, see docs/presets.md (default: cinematic)")
        ->transform(oneOf(looksByName()))
        ->option_text(lookNames());
    command
        .add_option("--window", o.state.window,
                    fmt::format("Of {} (default: range of --preset, else window of the series)",
                                pictures::looksListed(trace::isProjection).english()))
        ->option_text("CENTRE,WIDTH");
    command.add_flag("--shading", o.shading,
                     "Light dvr from the eye, with the preset's ambient and diffuse parts");
}

// How the preset's matter scatters light.
void addMatter(CLI::App& command, pictures::RenderRequest& o) {
    for (const scene::MatterParameter& p : scene::matterParameters()) {
        command
            .add_option_function<double>(
                std::string(p.option), [&p, &o](double value) { o.state.matter[p.id] = value; },
                fmt::format("{} (default: that of the preset)", p.does))
            ->check(between(p.low, p.high));
    }
}

// With how much work.
void addEffort(CLI::App& command, pictures::RenderRequest& o) {
    command.add_option(
        "--quality", o.effort.quality,
        "draft, normal, high, reference, or JSON file: samples, bounces, filter and denoising at once");
    command
        .add_option("--spp", o.effort.samplesPerPixel,
                    "Samples per pixel (default: of a PNG as --error 0.1 takes, at most about 256; of an EXR "
                    "64; 8 for "
                    "looks without chance)")
        ->check(CLI::Range(1u, pictures::kMostSamplesPerPixel));
    command
        .add_option("--error", o.effort.error,
                    "Trace until noise is this small, 0.01 of black to white; then --spp is about the most")
        ->check(between(1e-4, 1.0));
    const scene::Parameter& bounces = scene::parameter("bounces");
    command.add_option(std::string(bounces.option), o.effort.bounces, helpOf(bounces))
        ->check(CLI::Range(int(bounces.low), int(bounces.high)));
    command.add_flag_function(
        "--denoise,!--no-denoise", [&o](std::int64_t count) { o.effort.denoise = count > 0; },
        "Filter the noise out, guided by what is seen, or not (default: of a PNG whose --spp, --error and "
        "--quality nobody says); the picture says that it is denoised");
    command
        .add_option(
            "--filter", o.effort.filter,
            "How values between voxels are found, see docs/presets.md (default: that of --quality, or "
            "trilinear)")
        ->transform(asFilter())
        ->option_text(kFilterNames);
    command.add_option("--seed", o.seed, "Of the random numbers; the same seed gives the same picture");
}

// In which light.
void addLights(CLI::App& command, pictures::RenderRequest& o) {
    command.add_option("--lights", o.lights,
                       "Name from macula presets, light rig JSON, or HDR or EXR panorama");
    for (const scene::Parameter& p : scene::parameters()) {
        if (p.isWhole) continue;  // bounces are an option of effort: a quality sets them
        command
            .add_option_function<double>(
                std::string(p.option), [&p, &o](double value) { o.state.numbers[p.id] = value; }, helpOf(p))
            ->check(between(p.low, p.high));
    }
    command
        .add_flag("--auto-exposure", o.metersExposure,
                  "Find the exposure for the picture, as a camera does; the record of it tells which")
        ->excludes("--exposure");
    command
        .add_option(
            "--tone-map", o.state.toneMap,
            "How what is brighter than a display is shown: neutral, or hue, which keeps hues (default: "
            "neutral)")
        ->transform(asToneMap())
        ->option_text(kToneMapNames);
}

// What only a picture that is saved has.
void addEffects(CLI::App& command, pictures::RenderRequest& o) {
    command
        .add_option(
            "--lens-mm", o.effects.lensMm,
            "Diameter of a lens: what is nearer or farther than its focus is blurred (default: 0, all "
            "is sharp)")
        ->check(between(0.0, trace::kMostLensMm));
    command
        .add_option("--focus-mm", o.focus,
                    "Distance from the camera of what the lens shows sharp; auto: of what the middle of the "
                    "picture shows (default: auto)")
        ->option_text("MM|auto");
    command
        .add_option("--fog-mm", o.effects.fogMm,
                    "Fade what lies behind the nearest matter into the background, to 37 % over so many mm")
        ->check(between(pictures::kLeastFogMm, pictures::kMostFogMm));
}

}  // namespace

void addRenderOptions(CLI::App& command, pictures::RenderRequest& request) {
    pictures::RenderRequest& o = request;
    addInput(command, o);
    addCamera(command, o);
    addLook(command, o);
    addMatter(command, o);
    addEffort(command, o);
    addLights(command, o);
    addEffects(command, o);
    auto* removes = command.add_flag(
        "--remove-table", o.state.removeTable,
        "Leave out the table and what else lies beside the patient; CT only. What went is said (default: "
        "where it is sure what is patient, and no view is given)");
    command.add_flag("--keep-table", o.state.keepTable, "Show the table")->excludes(removes);
    addAdditions(command, o.additions);
    command.add_option("--clip", o.state.clip,
                       "Name from macula presets, or JSON file: what is shown of the volume");
    command
        .add_option_function<std::uint64_t>(
            "--voxel-memory", [&o](std::uint64_t mebibytes) { o.memory.voxelBytes = mebibytes << 20; },
            "At most so many MiB of the device for voxels (default: what is free)")
        ->check(CLI::Range(1, 1 << 20));
    command.add_option("--device", o.device, "Number or part of the name, see macula devices");
    command.add_flag("--keep-unfinished", o.keepUnfinished,
                     "When --error is stopped (Ctrl-C), write the picture as it is then");
    addOverwrite(command, o.overwrite);
    command.add_option("--json", o.json, "Write what was done and how long it took; - for stdout");
}

}  // namespace macula::cli
