// What a render was made from and what it took: in the metadata of the picture, and as JSON.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/camera.h"
#include "base/result.h"
#include "image/image_file.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::cli {

// Holds no patient data: the series is a digest, and files of the user are named by their kind only.
struct RenderRecord {
    std::string seriesDigest;
    std::string preset;
    std::string lights;
    std::string clip;
    bool tableRemoved = false;  // the table, or other things beside the patient, were found and left out
    std::string device;
    Camera camera;
    int width = 0;
    int height = 0;
    trace::Settings settings;
    bool presetFitted = false;            // its curves were stretched to the volume
    std::optional<DisplayWindow> window;  // that it is seen through; of projections alone
    trace::Statistics statistics;
    double loadSeconds = 0.0;
    double traceSeconds = 0.0;
    std::vector<std::string> notes;
};

image::Metadata metadata(const RenderRecord& record);

// To a file, whole or not at all; to stdout when the path is "-".
Result<void> writeStatistics(const RenderRecord& record, const std::filesystem::path& path);

}  // namespace macula::cli
