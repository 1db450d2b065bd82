// What `macula render` is told.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "app/picture/picture_effort.h"
#include "base/frames.h"
#include "dicom/scan.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::cli {

struct RenderOptions {
    std::filesystem::path path;
    std::filesystem::path output;
    std::string series;
    std::string preset;
    bool fit = false;
    ViewDirection view = ViewDirection::anterior;
    std::filesystem::path camera;
    double fovDeg = 0.0;  // 0: not given
    std::string size = "768x768";
    app::EffortWish effort;
    std::string window;
    trace::Settings settings;
    trace::MemoryLimits memory;
    std::string lights;  // empty: not given
    std::string clip;
    bool removeTable = false;
    dicom::ScanOptions how;
    std::string device;
    std::filesystem::path json;
    bool overwrite = false;
    bool keepUnfinished = false;
};

// "mip, minip and average": the looks that `isMeant` says.
std::string looksListed(bool (*isMeant)(trace::Look));

// Their defaults are what `options` holds; it must outlive the parsing.
void addRenderOptions(CLI::App& command, RenderOptions& options);

}  // namespace macula::cli
