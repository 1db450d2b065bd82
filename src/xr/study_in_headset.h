// A study in a headset, as somebody asked for it who has no window.
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
#include "xr/room_host.h"
#include "xr/room_view.h"
#include "xr/runtime.h"

namespace macula::xr {

struct ShowOptions {
    std::uint64_t frames = 0;        // after which it ends; 0: when who wears it ends it
    bool showsRoom = false;          // behind the anatomy, where the headset can
    glm::ivec2 eyePx{0};             // of the picture for each eye; 0: as the headset wants it
    std::uint64_t warmUpFrames = 0;  // that the figures of time leave out
};

// Empty: not given.
struct HeadsetRequest {
    std::filesystem::path path;
    std::string series;
    pictures::StateRequest state;
    std::string lights;  // a built-in name
    dicom::ScanOptions how;
    std::filesystem::path pictures = {};  // the folder for those that are taken; empty: none can be
    ShowOptions show = {};
};

struct HeadsetFigures {
    std::uint64_t frames = 0;  // submitted
    std::uint64_t empty = 0;   // of these, without pictures
    std::uint64_t sessions = 0;
    double seconds = 0.0;
    std::string headset;
    std::string runtime;
    std::string device;
    glm::ivec2 eyePx{0};  // of the pictures, at most
    FrameFigures times;
    std::uint64_t unsubmitted = 0;  // frames that were begun and not submitted
    std::uint64_t stepsDown = 0;    // of the governor
    std::uint64_t stepsUp = 0;
};
// A line for a person.
Text textOf(const HeadsetFigures& figures);

// Which of them can be shown on that volume.
std::vector<std::shared_ptr<const TransferFunction>> presetsFor(const scene::Catalogue& catalogue,
                                                                const Volume& volume);

// What is open somewhere, until who wears the headset ends it, or the progress says cancelled, which is an
// end as any other. A session that is lost is begun again, with everything where it was, once the headset is
// there; an error when it is away for ten seconds, and at the third loss within a minute.
Result<HeadsetFigures> showScene(RoomScene scene, RoomHost host, Progress& progress,
                                 const ShowOptions& request = {});

// Finds the headset first: nobody waits for a study that cannot be shown. As showScene; `note` hears of what
// there is to say, in English. `cancelled` as the progress says, after the session was ended as the headset
// wants it.
using Hears = std::function<void(const std::string&)>;
Result<HeadsetFigures> showStudy(const HeadsetRequest& request, const Hears& note, Progress& progress);

}  // namespace macula::xr
