// A picture as somebody asked for it, by names, files and numbers; and what that comes to.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/picture_effort.h"
#include "app/picture/picture_request.h"
#include "base/frames.h"
#include "base/result.h"
#include "base/volume.h"
#include "dicom/scan.h"
#include "pipeline/trace/path_tracer.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::app {

// Empty: not given.
struct RenderWish {
    std::filesystem::path path;
    std::filesystem::path output;
    std::string series;
    std::string preset;
    bool fit = false;
    ViewDirection view = ViewDirection::anterior;
    std::filesystem::path camera;
    double fovDeg = 0.0;  // 0: not given
    std::string size = "768x768";
    EffortWish effort;
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

// What was given and does nothing in this look; not what a quality or a default says.
std::vector<std::string> optionsWithoutEffect(const RenderWish& wish);

// The values that a projection shows: what was asked for; or the range of a preset that was asked for, fitted
// as the preset is; else those of the window's. Nothing for other looks.
Result<std::optional<DisplayWindow>> projectionWindow(const RenderWish& wish, const TransferFunction& preset,
                                                      const Volume& volume);

// All that can be wrong about the wish, the study not yet read. `lights` are those of the wish, or of the
// look.
Result<PictureRequest> requested(const RenderWish& wish, const std::string& lights);

}  // namespace macula::app
