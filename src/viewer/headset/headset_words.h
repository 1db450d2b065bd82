// The texts of the headset in the language of the window.
#pragma once

#include <memory>
#include <vector>

#include "pipeline/volume/transfer_function.h"
#include "xr/room_words.h"

namespace macula::viewer {

// The texts of the wrist panel in the language of the window, with the titles of `presets`, which can be
// chosen there. Called on the UI thread, since Qt's translators belong to it.
xr::RoomWords headsetWords(const std::vector<std::shared_ptr<const TransferFunction>>& presets);

}  // namespace macula::viewer
