// A study in a headset, as somebody asked for it who has no window.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "app/choice/catalogue.h"
#include "app/state/state_wish.h"
#include "base/progress.h"
#include "base/result.h"
#include "dicom/scan.h"
#include "xr/room_state.h"
#include "xr/room_view.h"
#include "xr/runtime.h"

namespace macula::xr {

// Empty: not given.
struct HeadsetWish {
    std::filesystem::path path;
    std::string series;
    app::StateWish state;
    std::string lights;  // a built-in name
    dicom::ScanOptions how;
    std::uint64_t frames = 0;             // after which it ends; 0: when who wears it ends it
    std::filesystem::path pictures = {};  // the folder for those that are taken; empty: none can be
};

struct HeadsetFigures {
    std::uint64_t frames = 0;  // submitted
    std::uint64_t empty = 0;   // of these, without pictures
    std::uint64_t sessions = 0;
    double seconds = 0.0;
    std::string headset;
};
// A line for a person.
std::string textOf(const HeadsetFigures& figures);

// Which of them can be shown on that volume.
std::vector<std::shared_ptr<const TransferFunction>> presetsFor(const app::Catalogue& catalogue,
                                                                const Volume& volume);

// What is open somewhere, until who wears the headset ends it, or the progress says cancelled, which is an
// end as any other. A session that is lost is begun again, with everything where it was; the third loss
// within a minute is an error. `frames` as above.
Result<HeadsetFigures> showScene(RoomScene scene, RoomHost host, Progress& progress,
                                 std::uint64_t frames = 0);

// Finds the headset first: nobody waits for a study that cannot be shown. As showScene; `note` hears of what
// there is to say. `cancelled` as the progress says, after the session was ended as the headset wants it.
using Hears = std::function<void(const std::string&)>;
Result<HeadsetFigures> showStudy(const HeadsetWish& wish, const Hears& note, Progress& progress);

}  // namespace macula::xr
