// Who shows the room to somebody, and hears what comes of it. Knows no OpenXR.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/volume/transfer_function.h"
#include "xr/room_state.h"
#include "xr/room_words.h"

namespace macula::xr {

// The window, or the command. All is called on the thread of the headset, and may be empty.
struct RoomHost {
    std::vector<std::shared_ptr<const TransferFunction>> presets = {};  // to choose from
    RoomWords words = {};
    bool isCalibrated = true;             // the volume, as in Provenance: of no other a size is told
    std::filesystem::path pictures = {};  // where those that are taken go; empty: none can be taken
    std::function<void(const std::string&)> note = {};  // in these words
    std::function<void(const RoomState&)> changed = {};
    // What was chosen elsewhere since the last time.
    std::function<std::optional<RoomState>()> wanted = {};
    // A few times a second.
    std::function<void(EyeView)> mirror = {};
};

}  // namespace macula::xr
