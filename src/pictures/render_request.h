// The options of a render, by names, files and numbers, and the PictureRequest made from them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "dicom/scan.h"
#include "pictures/addition_request.h"
#include "pictures/picture_effort.h"
#include "pictures/picture_request.h"
#include "pictures/state_request.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::pictures {

// Empty fields: not given.
struct RenderRequest {
    std::filesystem::path path;
    std::filesystem::path output;
    std::string series;
    StateRequest state;
    std::string lights;           // as chooseLights takes it, also a panorama
    bool metersExposure = false;  // overrides the exposure of the view
    AdditionRequest additions;
    bool shading = false;  // for ray casts, whatever the preset says
    std::string size = "768x768";
    std::string background;  // as backgroundOf, or kTransparent; overrides that of the view
    PictureEffects effects = {};
    std::string focus = {};  // parseFocus; overrides effects.focusMm
    EffortRequest effort;    // overrides the saved view
    std::uint32_t seed = 0;
    trace::MemoryLimits memory;
    dicom::ScanOptions how;
    std::string device;
    std::filesystem::path json;
    bool overwrite = false;
    bool keepUnfinished = false;
};

// Lists the looks for which `isMeant` is true: "mip, minip and average".
Text looksListed(bool (*isMeant)(trace::Look));

// Sentences on options that have no effect in this look or with this preset; not on values from a view, a
// quality or a default. makeAdditions reports on additions.
std::vector<Text> optionsWithoutEffect(const RenderRequest& request, trace::Look look,
                                       const TransferFunction& drawn);

// The picture that a RenderRequest asks for, without what depends on the study.
struct RequestedPicture {
    scene::StudyState state;
    PictureRequest request;  // to be completed: volume, preset, clip, additions, settingsToDraw
    std::string lights;      // publicLightsName
    std::string clip;        // publicClipName
    ResolvedAdditions additions{};
};

// Checks the request before the study is read.
Result<RequestedPicture> requestedPicture(const RenderRequest& request);

// The settings for the volume; call it after completeState has put the preset into the state.
trace::Settings settingsToDraw(const RenderRequest& request, const scene::StudyState& state,
                               const Volume& volume);

}  // namespace macula::pictures
