// What is written in a headset, in the language of the window.
#pragma once

#include <memory>
#include <vector>

#include "pipeline/volume/transfer_function.h"
#include "xr/room_words.h"

namespace macula::viewer {

// On the UI thread. `presets` are those to choose from there: their titles are translated, too.
xr::RoomWords headsetWords(const std::vector<std::shared_ptr<const TransferFunction>>& presets);

}  // namespace macula::viewer
