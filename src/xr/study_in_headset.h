// Shows a study in a headset, for callers with or without a window.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/scan.h"
#include "pictures/state_request.h"
#include "scene/choice/catalogue.h"
#include "xr/frame_statistics.h"
#include "xr/room_choice.h"
#include "xr/room_view.h"
#include "xr/runtime.h"

namespace macula::xr {

struct ShowOptions {
    std::uint64_t frames = 0;        // ends after this many; 0: when the wearer ends it
    bool showsRoom = false;          // the real room behind the anatomy, if possible
    glm::ivec2 eyePx{0};             // size of each eye's picture; 0: as the headset recommends
    std::uint64_t warmUpFrames = 0;  // not counted in the figures of time
};

// Empty members: not given.
struct HeadsetRequest {
    std::filesystem::path path;
    std::string series;
    pictures::StateRequest state;
    std::string lights;  // a built-in name
    dicom::ScanOptions how;
    std::filesystem::path pictures = {};  // folder for pictures taken there; empty: none can be taken
    ShowOptions show = {};
};

struct HeadsetFigures {
    std::uint64_t frames = 0;  // submitted
    std::uint64_t empty = 0;   // how many of them had no pictures
    std::uint64_t sessions = 0;
    double seconds = 0.0;
    std::string headset;
    std::string runtime;
    std::string device;
    glm::ivec2 eyePx{0};  // the largest size of the pictures
    FrameFigures times;
    std::uint64_t unsubmitted = 0;  // frames begun but not submitted
    std::uint64_t stepsDown = 0;    // levels that the governor went down
    std::uint64_t stepsUp = 0;
};
// Lines for a person.
Text textOf(const HeadsetFigures& figures);

// The presets of the catalogue that can show that volume.
std::vector<std::shared_ptr<const TransferFunction>> presetsFor(const scene::Catalogue& catalogue,
                                                                const Volume& volume);

// Shows an open scene until the wearer ends it, or the progress is cancelled, which is a normal end. A lost
// session is begun again, with everything where it was, once the headset is back; an error if it is away for
// ten seconds, and at the third loss within a minute.
Result<HeadsetFigures> showScene(RoomScene scene, RoomHost host, Progress& progress,
                                 const ShowOptions& request = {});

// Finds the headset first, so that nobody waits for a study that cannot be shown. Otherwise like showScene;
// `note` gets messages in English. `cancelled` if the progress was, after the session has ended in order.
using Hears = std::function<void(const std::string&)>;
Result<HeadsetFigures> showStudy(const HeadsetRequest& request, const Hears& note, Progress& progress);

}  // namespace macula::xr
