// The choices made in the room, or elsewhere for it, as steps that can be undone; and whom they are told.
// Knows no OpenXR.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "pipeline/volume/transfer_function.h"
#include "xr/room_state.h"
#include "xr/room_words.h"

namespace macula::xr {

// The program that shows the room, and receives the choices made there: the window, or the command. Its
// functions are called on the headset's thread, and may be empty.
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
