// Steps from preset to preset, and along the values of one. Knows no OpenXR.
#pragma once

#include <string>

#include "xr/room_host.h"
#include "xr/room_state.h"

namespace macula::xr {

// The state with the preset `steps` after its own in the host's list, cyclically. A preset that is not in the
// list counts as before the first.
RoomState withPreset(RoomState state, const RoomHost& host, int steps);
// The state with its curve moved along the values; the host's preset is copied first.
RoomState withShift(RoomState state, const RoomHost& host, int steps);
// How far the curve was moved from the host's preset, in the host's words.
std::string shiftText(const RoomState& state, const RoomHost& host);

}  // namespace macula::xr
