// What the benchmarks of the tracer have in common: what is traced, how it is seen, and on which device.
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

namespace macula::evaluate {

struct BenchStudyOptions {
    std::filesystem::path path;
    std::string series;
    dicom::ScanOptions how;
    std::string preset;
    std::string thenPreset;  // another, for who changes it; empty: none
    std::string lights;
    std::string device;
    std::filesystem::path camera;  // as scene::readCamera; empty: from the front, all of the volume in it
    int size = 512;                // of the picture, which is square
};

struct BenchStudy {
    std::shared_ptr<const Volume> volume;
    TransferFunction function;
    trace::Environment environment;
    std::shared_ptr<gpu::Device> device;
    trace::View view;
    std::string seriesDigest;
    std::string preset;  // names that may be told
    std::string lights;
    std::vector<Text> notes;                 // sentences for a person about the study and the preset
    std::vector<Text> warnings;              // those of them that change what is seen
    std::optional<scene::StudyPreset> then;  // BenchStudyOptions::thenPreset

    // All of it, to be traced and to make models of.
    Result<live::SceneOnDevice> putOnDevice() const;
    // With its study set; the settings are the caller's.
    Result<trace::PathTracer> makeTracer() const;
    // What such a tracer shows so far, over black; waits.
    Result<image::Image> readShown(trace::PathTracer& tracer) const;
};

// Adds samples to each pixel, a few at a time, and advances the progress by them. Fails with cancelled, and
// as PathTracer::trace.
Result<void> traceMore(trace::PathTracer& tracer, std::uint32_t samples, Progress& progress);

Result<BenchStudy> openBenchStudy(const BenchStudyOptions& options, Progress& progress);

// What a report begins with.
nlohmann::ordered_json describe(const std::string& benchmark, const BenchStudy& study);

}  // namespace macula::evaluate
