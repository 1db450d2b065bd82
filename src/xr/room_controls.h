// All that a person does in the room, from frame to frame: hands, the panel at the wrist, tools, turns; and
// what floats there for that. What was chosen stays when a session is lost. Knows no OpenXR.
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/frames.h"
#include "base/result.h"
#include "xr/clip_tools.h"
#include "xr/comfort.h"
#include "xr/grasp.h"
#include "xr/panel_picture.h"
#include "xr/room_host.h"
#include "xr/wrist_panel.h"

namespace macula::xr {

enum class RoomPicture { panel, notice, pointer, tile, ring };
inline constexpr std::size_t kRoomPictures = 5;

// A flat picture in the stage: x to the right, y up, seen from its +z.
struct Floating {
    RoomPicture picture = RoomPicture::panel;
    Pose pose;
    glm::dvec2 sizeM{0.0};
};

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

enum class Lasts { forGood, forALook };

class RoomControls {
  public:
    // Shows another state. False, and all is as it was, when nothing of it could be seen; an error ends the
    // session.
    using Show = std::function<Result<bool>(const RoomState&, Lasts)>;

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

    const RoomState& state() const { return history_.now(); }
    const RoomHost& host() const { return host_; }
    // Stands before the eyes for some seconds, and goes to the host. `sentence` names no patient, and is in
    // the words of the host.
    void tell(const std::string& sentence);

    // A picture that floats. Its number changes when it does.
    const PanelPicture& picture(RoomPicture which) const { return pictures_.at(std::size_t(which)).picture; }
    std::uint64_t pictureNumber(RoomPicture which) const { return pictures_.at(std::size_t(which)).number; }

    ClipTool toolOf(std::size_t hand) const;
    std::size_t panelHand() const { return panelHand_; }
    std::optional<Pose> panel() const { return panel_; }
    std::optional<PanelButton> pointedAt() const { return pointedAt_; }
    const PanelTexts& texts() const { return texts_; }

  private:
    struct Drawn {
        PanelPicture picture;
        std::uint64_t number = 1;
    };

    Result<void> takeWanted(const Show& show);
    Result<void> usePanel(const RoomFrame& frame, const Show& show, RoomFollowed& followed);
    Result<void> press(PanelButton button, const RoomFrame& frame, const Show& show, RoomFollowed& followed);
    TwoHands handsBesidePanel(const TwoHands& hands);
    void grasp(const RoomFrame& frame, const TwoHands& hands, RoomFollowed& followed);
    Result<void> useTool(std::size_t hand, const RoomFrame& frame, const Hand& seen, const Show& show,
                         RoomFollowed& followed);
    Result<void> cut(std::size_t hand, const Pose& at, Lasts lasts, const Show& show,
                     const glm::dmat4& stageFromWorld);
    Result<bool> change(RoomState next, const Show& show);
    Result<void> undo(const Show& show);
    RoomState withPreset(int steps) const;
    RoomState withShift(int steps) const;
    std::optional<std::size_t> presetIndex() const;
    std::string shiftText() const;
    std::string sizeText(double scale) const;
    const RoomWords& words() const { return host_.words; }
    void showPanel(RoomFollowed& followed);
    void showNotice(const RoomFrame& frame, RoomFollowed& followed);
    void draw(RoomPicture which, PanelPicture picture);

    RoomHost host_;
    RoomHistory history_;
    Grasp grasp_;
    std::array<HeldTool, 2> tools_;
    SnapTurns turns_;
    Fade fade_;
    bool hasKnife_ = true;
    ClipTool held_ = ClipTool::none;  // in the hand with the panel
    std::size_t panelHand_ = 0;
    std::optional<Pose> panel_;      // where it was in this frame
    std::optional<glm::dvec2> hit_;  // of the ray, in its pixels
    std::optional<PanelButton> pointedAt_;
    bool isPressed_ = false;
    bool isOfPanel_ = false;  // what the pointing hand holds down was pressed on the panel
    PanelTexts texts_;        // as they are now
    PanelTexts drawnTexts_;   // and as they stand on the panel
    std::optional<PanelButton> drawnPointedAt_;
    std::array<Drawn, kRoomPictures> pictures_;
    std::string notice_;
    std::string drawnNotice_;
    double noticeUntil_ = 0.0;
    double seconds_ = 0.0;
    double wantedAt_ = -1e9;  // when something that was chosen elsewhere came last
    bool wasWanted_ = false;  // the last step was that
};

}  // namespace macula::xr
