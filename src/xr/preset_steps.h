// Steps from preset to preset, and along the values of one. Knows no OpenXR.
#pragma once

#include <string>

#include "xr/room_host.h"
#include "xr/room_state.h"

namespace macula::xr {

// The state with the preset that comes so many after its own in the list of the host, going round. One that
// is not in the list stands before the first.
RoomState withPreset(RoomState state, const RoomHost& host, int steps);
// The state with its curve moved; a preset of the host becomes an own copy first.
RoomState withShift(RoomState state, const RoomHost& host, int steps);
// How far the curve was moved from the preset of the host, in the words of the host.
std::string shiftText(const RoomState& state, const RoomHost& host);

}  // namespace macula::xr
