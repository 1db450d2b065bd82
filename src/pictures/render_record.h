// What a render was made from and what it took: in the metadata of the picture, and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/camera.h"
#include "image/image_file.h"
#include "pictures/drawn_picture.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::app {

// Holds no patient data: the series is a digest, and files of the user are named by their kind only.
struct RenderRecord {
    std::string seriesDigest;
    std::string preset;
    std::string lights;
    std::string clip;
    bool tableRemoved = false;   // the table, or other things beside the patient, were found and left out
    std::string masked = {};     // Mask::remark: what of the volume was left out by voxels
    std::string additions = {};  // Additions::remark: a second volume, coloured segments
    std::string device;
    Camera camera;
    std::string view = {};        // from where, where a direction fitted the camera: nameOf(ViewDirection)
    std::string whyView = {};     // "chosen", or nameOf(ViewReason); empty: a camera was given
    std::string background = {};  // "#rrggbb", "transparent"; empty: of light, which has none
    int width = 0;
    int height = 0;
    trace::Settings settings;
    PictureEffects effects = {};  // as they took effect: with the focus that was found
    // The numbers of matterParameters(), by id, of the preset before it is fitted to the volume.
    std::vector<std::pair<std::string_view, double>> matter = {};
    bool presetFitted = false;            // its curves were stretched to the volume
    std::optional<DisplayWindow> window;  // that it is seen through; of projections alone
    std::string unit = {};                // of the values: unitSymbol, no word of a file
    trace::Statistics statistics;
    double loadSeconds = 0.0;
    double traceSeconds = 0.0;
    std::vector<std::string> notes;

    // What was drawn, and how; with its notes.
    void add(const PictureRequest& request, const DrawnPicture& picture);
};

// For the picture itself: keys "macula:…" and "Software"; of the series what publicSeries says.
image::Metadata metadata(const RenderRecord& record);

// The whole record, with times; the error is null when it is not known.
nlohmann::ordered_json toJson(const RenderRecord& record);

}  // namespace macula::app
