// A picture as somebody asked for it, by names, files and numbers; and what that comes to.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "dicom/scan.h"
#include "pictures/addition_wish.h"
#include "pictures/picture_effort.h"
#include "pictures/picture_request.h"
#include "pictures/state_wish.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::app {

// Empty: not given.
struct RenderWish {
    std::filesystem::path path;
    std::filesystem::path output;
    std::string series;
    StateWish state;
    std::string lights;           // as chooseLights, a panorama too
    bool metersExposure = false;  // instead of that of the view
    AdditionWish additions;
    bool shading = false;  // of ray casts, whatever the preset asks for
    std::string size = "768x768";
    std::string background;  // as backgroundOf, or kTransparent; instead of that of the view
    PictureEffects effects = {};
    std::string focus = {};  // parseFocus; in the place of effects.focusMm
    EffortWish effort;       // counts more than the view that was saved
    std::uint32_t seed = 0;
    trace::MemoryLimits memory;
    dicom::ScanOptions how;
    std::string device;
    std::filesystem::path json;
    bool overwrite = false;
    bool keepUnfinished = false;
};

// "mip, minip and average": the looks that `isMeant` says.
std::string looksListed(bool (*isMeant)(trace::Look));

// What was given and does nothing in this look, or to the preset that is drawn; not what a view, a quality or
// a default says. makeAdditions tells of additions.
std::vector<std::string> optionsWithoutEffect(const RenderWish& wish, trace::Look look,
                                              const TransferFunction& drawn);

// What a wish comes to, but for what the study decides.
struct WishedPicture {
    StudyState state;
    PictureRequest request;  // volume, preset, clip and additions are to be put in, and settingsToDraw
    std::string lights;      // what may be told of them: publicLightsName
    std::string clip;        // publicClipName
    AdditionChoice additions{};
};

// All that can be wrong about the wish, the study not yet read.
Result<WishedPicture> wishedPicture(const RenderWish& wish);

// For the volume, when completeState has put the preset into the state.
trace::Settings settingsToDraw(const RenderWish& wish, const StudyState& state, const Volume& volume);

}  // namespace macula::app
