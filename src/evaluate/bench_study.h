// What the benchmarks of the tracer share: the study, the view, and the device.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "dicom/scan.h"
#include "image/image.h"
#include "live/device/scene_on_device.h"
#include "pipeline/gpu/device.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/path_tracer.h"
#include "pipeline/volume/transfer_function.h"
#include "scene/choice/study_preset.h"
#include "scene/drawing/drawing.h"

namespace macula::evaluate {

struct BenchStudyOptions {
    std::filesystem::path path;
    std::string series;
    dicom::ScanOptions how;
    std::string preset;
    std::string thenPreset;  // a second preset, for benchmarks that change it; may be empty
    std::string lights;
    std::string device;
    std::filesystem::path camera;  // for scene::readCamera; empty: from the front, with all of the volume
    int size = 512;                // side of the square picture, in pixels
};

struct BenchStudy {
    std::shared_ptr<const Volume> volume;
    TransferFunction function;
    trace::Environment environment;
    std::shared_ptr<gpu::Device> device;
    trace::View view;
    std::string seriesDigest;
    std::string preset;  // this and `lights`: names without private parts
    std::string lights;
    std::vector<Text> notes;                 // sentences about the study and the preset
    std::vector<Text> warnings;              // those that change what a picture shows
    std::optional<scene::StudyPreset> then;  // BenchStudyOptions::thenPreset

    // Puts the scene on the device, for tracing and for models.
    Result<live::SceneOnDevice> putOnDevice() const;
    // A tracer of this study and view; the caller sets the settings.
    Result<trace::PathTracer> makeTracer() const;
    // The present picture of such a tracer, over black. Waits for the device.
    Result<image::Image> readShown(trace::PathTracer& tracer) const;
};

// Adds samples to each pixel, a few at a time, and advances the progress by them. Fails with `cancelled`, and
// as PathTracer::trace does.
Result<void> traceMore(trace::PathTracer& tracer, std::uint32_t samples, Progress& progress);

Result<BenchStudy> openBenchStudy(const BenchStudyOptions& options, Progress& progress);

// The beginning of a report.
nlohmann::ordered_json describe(const std::string& benchmark, const BenchStudy& study);

// A number of a report; null if it is missing.
nlohmann::ordered_json orNull(const std::optional<double>& number);

// Compiles the kernels of first models before any model is timed: makes a small one and discards it. Fails as
// hybrid::makeFirstModel does. The tracer is left with other settings and another view.
Result<void> compileModelKernels(const BenchStudy& study, live::SceneOnDevice& scene, int bounces,
                                 Progress& progress);

// Fails with usage for lights that are not built in: a window has no others.
Result<std::shared_ptr<const trace::LightRig>> builtInLights(const std::string& name);

// The drawing with which a window would show the study: complete, with default settings. Fails likewise.
Result<scene::Drawing> drawingOf(const BenchStudy& study);

}  // namespace macula::evaluate
