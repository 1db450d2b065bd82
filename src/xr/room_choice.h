// What was chosen in the room, or elsewhere for it, in steps that can be undone. Knows no OpenXR.
#pragma once

#include <functional>
#include <utility>

#include "base/result.h"
#include "xr/room_host.h"
#include "xr/room_state.h"

namespace macula::xr {

enum class Lasts { forGood, forALook };

// Shows another state. False, and all is as it was, when nothing of it could be seen; an error ends the
// session.
using ShowRoom = std::function<Result<bool>(const RoomState&, Lasts)>;

class RoomChoice {
  public:
    explicit RoomChoice(RoomState first) : history_(std::move(first)) {}

    const RoomState& now() const { return history_.now(); }
    bool canUndo() const { return history_.canUndo(); }

    // Shows the next state, and tells the host. False when nothing of it could be seen.
    Result<bool> change(RoomState next, const RoomHost& host, const ShowRoom& show);
    // Does nothing where no step is left, or where the one before cannot be shown.
    Result<void> undo(const RoomHost& host, const ShowRoom& show);
    // Shows what was chosen elsewhere. The host, who knows of that, is told nothing.
    Result<void> takeWanted(const RoomHost& host, double seconds, const ShowRoom& show);
    // Shows the present state again: what was gone for a look comes back where nothing stays gone.
    Result<void> comeBack(const ShowRoom& show) const;

  private:
    RoomHistory history_;
    double wantedAt_ = -1e9;  // when something that was chosen elsewhere came last
    bool wasWanted_ = false;  // the last step was that
};

}  // namespace macula::xr
