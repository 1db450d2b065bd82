// The program that shows the room, and receives the choices made there. Knows no OpenXR.
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

// The window, or the command. Its functions are called on the headset's thread, and may be empty.
struct RoomHost {
    std::vector<std::shared_ptr<const TransferFunction>> presets = {};  // to choose from
    RoomWords words = {};
    bool isCalibrated = true;             // whether the volume is (Provenance); if not, no sizes are shown
    std::filesystem::path pictures = {};  // folder for pictures taken there; empty: none can be taken
    std::function<void(const std::string&)> note = {};  // a sentence, in `words`
    std::function<void(const RoomState&)> changed = {};
    // Returns the choice made elsewhere since the last call, if any.
    std::function<std::optional<RoomState>()> wanted = {};
    // Called a few times a second.
    std::function<void(EyeView)> mirror = {};
};

}  // namespace macula::xr
