// All that a person does in the room, from frame to frame: hands, the panel at the wrist, tools, turns; and
// what floats there for that. What was chosen stays when a session is lost. Knows no OpenXR.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/frames.h"
#include "base/result.h"
#include "xr/clip_tools.h"
#include "xr/comfort.h"
#include "xr/floating_pictures.h"
#include "xr/grasp.h"
#include "xr/panel_picture.h"
#include "xr/panel_pointer.h"
#include "xr/room_choice.h"
#include "xr/room_host.h"
#include "xr/wrist_panel.h"

namespace macula::xr {

// Felt in a hand.
struct Pulse {
    std::size_t hand = 0;
    float strength = 0.5f;  // 0 to 1
    double ms = 20.0;
};

struct RoomFrame {
    double seconds = 0.0;
    Pose head;
    TwoHands hands;
    bool isTracked = true;  // the headset sees where it is
    Box seenMm;             // what can be seen, in the world
};

struct RoomFollowed {
    glm::dmat4 stageFromWorld{1.0};
    std::vector<Pulse> pulses = {};
    std::vector<Floating> floating = {};  // what comes later lies in front
    double light = 1.0;                   // of all that is seen, 0 to 1
    bool wantsPicture = false;
};

class RoomControls {
  public:
    using Show = ShowRoom;

    RoomControls(RoomHost host, RoomState first);

    // In this order: what was chosen elsewhere, the panel, a turn, the grasp, tools.
    Result<RoomFollowed> follow(const glm::dmat4& stageFromWorld, const RoomFrame& frame, const Show& show);
    // It stands elsewhere all of a sudden: what is held does not jump back.
    void takeAnew() { grasp_.takeAnew(); }
    // Nobody has looked at the hands for a while: what they hold is taken anew, and a cut that was begun is
    // none, wherever they are by now.
    void interrupt();
    // A frame of which nobody knows where the eyes are.
    void goDark(double seconds) {
        fade_.goDark(seconds);
        interrupt();
    }

    const RoomState& state() const { return choice_.now(); }
    const RoomHost& host() const { return host_; }
    // Stands before the eyes for some seconds, and goes to the host. `sentence` names no patient, and is in
    // the words of the host.
    void tell(const std::string& sentence);

    // A picture that floats. Its number changes when it does.
    const PanelPicture& picture(RoomPicture which) const { return pictures_.picture(which); }
    std::uint64_t pictureNumber(RoomPicture which) const { return pictures_.number(which); }

    ClipTool toolOf(std::size_t hand) const;
    std::size_t panelHand() const { return pointer_.panelHand(); }
    std::optional<Pose> panel() const { return pointer_.panel(); }
    std::optional<PanelButton> pointedAt() const { return pointer_.pointedAt(); }
    const PanelTexts& texts() const { return texts_; }

  private:
    Result<void> usePanel(const RoomFrame& frame, const Show& show, RoomFollowed& followed);
    Result<void> press(PanelButton button, const RoomFrame& frame, const Show& show, RoomFollowed& followed);
    void grasp(const RoomFrame& frame, const TwoHands& hands, RoomFollowed& followed);
    Result<void> useTool(std::size_t hand, const RoomFrame& frame, const Hand& seen, const Show& show,
                         RoomFollowed& followed);
    Result<void> cut(std::size_t hand, const Pose& at, Lasts lasts, const Show& show,
                     const glm::dmat4& stageFromWorld);
    Result<bool> change(RoomState next, const Show& show);
    std::string sizeText(double scale) const;
    const RoomWords& words() const { return host_.words; }
    void showPanel(RoomFollowed& followed);
    void showNotice(const RoomFrame& frame, RoomFollowed& followed);

    RoomHost host_;
    RoomChoice choice_;
    Grasp grasp_;
    std::array<HeldTool, 2> tools_;
    SnapTurns turns_;
    Fade fade_;
    PanelPointer pointer_;
    FloatingPictures pictures_;
    bool hasKnife_ = true;
    ClipTool held_ = ClipTool::none;  // in the hand with the panel
    PanelTexts texts_;                // as they are now
    std::string notice_;
    double noticeUntil_ = 0.0;
    double seconds_ = 0.0;
};

}  // namespace macula::xr
