// The inputs and costs of a render, for the metadata of the picture and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/camera.h"
#include "base/text.h"
#include "image/image_file.h"
#include "pictures/drawn_picture.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::pictures {

// Holds no patient data: the series is a digest, and files of the user are named by their kind only.
struct RenderRecord {
    std::string seriesDigest;
    std::string preset;
    std::string lights;
    std::string clip;
    bool tableRemoved = false;   // the table, or other things next to the patient, were found and removed
    std::string masked = {};     // Mask::remark in English: the parts of the volume that voxel masks removed
    std::string additions = {};  // Additions::remark, likewise: a second volume, coloured segments
    std::string device;
    Camera camera;
    std::string view = {};        // nameOf(ViewDirection) of a fitted camera; empty: a camera was given
    std::string whyView = {};     // "chosen", or nameOf(ViewReason); empty: a camera was given
    std::string background = {};  // "#rrggbb", "transparent"; empty: linear light, without one
    int width = 0;
    int height = 0;
    trace::Settings settings;
    PictureEffects effects = {};  // as they took effect, with the focus that was found
    // By id: the values of matterParameters() of the preset, before its fit to the volume.
    std::vector<std::pair<std::string_view, double>> matter = {};
    bool presetFitted = false;            // its curves were stretched to the volume
    std::optional<DisplayWindow> window;  // for projections only
    std::string unit = {};                // unit of the values: unitSymbol, never text of a file
    trace::Statistics statistics;
    double loadSeconds = 0.0;
    double traceSeconds = 0.0;
    std::vector<Text> notes;

    // Adds the request, the drawn picture and its notes.
    void add(const PictureRequest& request, const DrawnPicture& picture);
};

// For the file of the picture: keys "macula:…" and "Software"; the series as publicSeries.
image::Metadata metadata(const RenderRecord& record);

// The whole record, with times; estimatedError is null when it is unknown.
nlohmann::ordered_json toJson(const RenderRecord& record);

// The name of a series in pictures that leave the machine: the digest of LoadedStudy::seriesDigest with the
// key of this installation. It groups the pictures of one series that were made here, and tells others
// nothing. Returns "phantom" and an empty digest unchanged; "unknown" if no key can be stored.
std::string publicSeries(const std::string& seriesDigest);

}  // namespace macula::pictures
