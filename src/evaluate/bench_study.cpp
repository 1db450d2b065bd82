#include "evaluate/bench_study.h"

#include <algorithm>

#include "evaluate/measurement.h"
#include "evaluate/shown_picture.h"
#include "live/device/open_device.h"
#include "pipeline/hybrid/model/first_model.h"
#include "pipeline/trace/device_scene.h"
#include "scene/camera/camera_file.h"
#include "scene/choice/catalogue.h"
#include "scene/choice/lights_choice.h"
#include "study/open/loaded_study.h"

namespace macula::evaluate {

Result<live::SceneOnDevice> BenchStudy::putOnDevice() const {
    return live::putOnDevice(
        device, {.volume = volume, .function = function, .clip = {}, .environment = environment});
}

Result<trace::PathTracer> BenchStudy::makeTracer() const {
    MACULA_TRY(trace::PathTracer tracer, trace::PathTracer::create(device));
    MACULA_TRY_VOID(tracer.scene().setVolume(volume));
    MACULA_TRY_VOID(tracer.scene().setTransferFunction(function));
    MACULA_TRY_VOID(tracer.scene().setEnvironment(environment));
    MACULA_TRY_VOID(tracer.setView(view));
    return tracer;
}

Result<BenchStudy> openBenchStudy(const BenchStudyOptions& options, Progress& progress) {
    MACULA_TRY(study::LoadedStudy study,
               study::loadStudy(options.path, options.series, progress, 0, options.how));
    bringTo16Bits(study);
    MACULA_TRY(scene::StudyPreset preset, scene::choosePresetFor(study, options.preset));
    std::optional<scene::StudyPreset> then;
    if (!options.thenPreset.empty()) {
        MACULA_TRY(then, scene::choosePresetFor(study, options.thenPreset));
    }
    MACULA_TRY(trace::Environment environment, scene::chooseLights(options.lights));
    Camera camera = frameBox(study.volume->worldBox(), ViewDirection::anterior, 30.0, 1.0);
    if (!options.camera.empty()) {
        MACULA_TRY(camera, scene::readCamera(options.camera));
    }
    MACULA_TRY(const gpu::Instance instance, gpu::Instance::create());
    MACULA_TRY(auto device, gpu::Device::create(instance, live::deviceOptions(options.device)));
    return BenchStudy{.volume = study.volume,
                      .function = std::move(preset.function),
                      .environment = std::move(environment),
                      .device = std::move(device),
                      .view = {.camera = camera, .width = options.size, .height = options.size},
                      .seriesDigest = study.seriesDigest,
                      .preset = std::move(preset.publicName),
                      .lights = scene::publicLightsName(options.lights),
                      .notes = std::move(study.notes),
                      .warnings = std::move(study.warnings),
                      .then = std::move(then)};
}

Result<image::Image> BenchStudy::readShown(trace::PathTracer& tracer) const {
    MACULA_TRY(const std::vector<std::uint8_t> rgba, tracer.readDisplay(glm::vec3(0.0f)));
    return imageOf(rgba, {view.width, view.height});
}

Result<void> traceMore(trace::PathTracer& tracer, std::uint32_t samples, Progress& progress) {
    constexpr std::uint32_t kPortion = 16;
    for (std::uint32_t done = 0; done < samples; done += kPortion) {
        const std::uint32_t count = std::min(kPortion, samples - done);
        MACULA_TRY(const bool whole, tracer.trace(count, [&] { return !progress.cancelled(); }));
        if (!whole || progress.cancelled()) return cancelledError();
        progress.advance(count);
    }
    return {};
}

nlohmann::ordered_json describe(const std::string& benchmark, const BenchStudy& study) {
    const glm::ivec3 voxels = study.volume->size();
    return {{"benchmark", benchmark},
            {"version", MACULA_VERSION},
            {"device", study.device->info().name},
            {"driver", study.device->info().driver},
            {"study", study.seriesDigest},
            {"voxels", {voxels.x, voxels.y, voxels.z}},
            {"preset", study.preset},
            {"lights", study.lights},
            {"picture", {study.view.width, study.view.height}}};
}

nlohmann::ordered_json orNull(const std::optional<double>& number) {
    return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json();
}

Result<void> compileModelKernels(const BenchStudy& study, live::SceneOnDevice& scene, int bounces,
                                 Progress& progress) {
    hybrid::FirstModelOptions least{.views = 1, .samplesPerPixel = 1, .directions = 2, .sizePx = 32};
    least.points.count = 256;
    least.bounces = bounces;
    least.iterations = 10;
    MACULA_TRY([[maybe_unused]] const hybrid::FirstModel model,
               hybrid::makeFirstModel(study.device, scene.tracer, scene.traced.seenMm(), least, progress));
    return {};
}

Result<std::shared_ptr<const trace::LightRig>> builtInLights(const std::string& name) {
    MACULA_TRY(const scene::Catalogue catalogue, scene::builtInCatalogue());
    return scene::findLights(catalogue, name);
}

Result<scene::Drawing> drawingOf(const BenchStudy& study) {
    scene::Drawing drawing;
    drawing.transferFunction = std::make_shared<const TransferFunction>(study.function);
    MACULA_TRY(drawing.lights, builtInLights(study.lights));
    return drawing;
}

}  // namespace macula::evaluate
