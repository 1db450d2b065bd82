// The choices made in the room, or elsewhere for it, as steps that can be undone; among them steps from
// preset to preset, and along the values of one. Knows no OpenXR.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "base/result.h"
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

enum class Lasts { forGood, forALook };

// Shows another state. False, and nothing changes, if nothing would be visible; an error ends the session.
using ShowRoom = std::function<Result<bool>(const RoomState&, Lasts)>;

class RoomChoice {
  public:
    explicit RoomChoice(RoomState first) : history_(std::move(first)) {}

    const RoomState& now() const { return history_.now(); }
    bool canUndo() const { return history_.canUndo(); }

    // Shows the next state, and notifies the host. False if nothing would be visible.
    Result<bool> change(RoomState next, const RoomHost& host, const ShowRoom& show);
    // Does nothing if there is no step to undo, or if the state before cannot be shown.
    Result<void> undo(const RoomHost& host, const ShowRoom& show);
    // Shows a choice made elsewhere. Does not notify the host, which made it.
    Result<void> takeWanted(const RoomHost& host, double seconds, const ShowRoom& show);
    // Shows the present state again, to end the preview of a cut that was not made.
    Result<void> comeBack(const ShowRoom& show) const;

  private:
    RoomHistory history_;
    double wantedAt_ = -1e9;  // when the last choice from elsewhere came
    bool wasWanted_ = false;  // the last step came from elsewhere
};

}  // namespace macula::xr
