// Handles all that a person does in the room, from frame to frame: hands, the panel at the wrist, tools,
// turns; and the pictures that float there. Choices survive the loss of a session. Knows no OpenXR.
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
#include "xr/eyes.h"
#include "xr/grasp.h"
#include "xr/panel_picture.h"
#include "xr/room_choice.h"
#include "xr/room_words.h"
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

// Holds the pictures, and redraws one only when it changes.
class FloatingPictures {
  public:
    FloatingPictures();

    const PanelPicture& picture(RoomPicture which) const { return pictures_.at(std::size_t(which)).picture; }
    // Changes when the picture does.
    std::uint64_t number(RoomPicture which) const { return pictures_.at(std::size_t(which)).number; }

    void drawPanel(const PanelTexts& texts, const RoomWords& words, std::optional<PanelButton> pointedAt);
    void drawNotice(const std::string& text);

    // The placement of a sentence before that head.
    static Floating noticeBefore(const Pose& head);
    // Marks where the pointing ray meets the panel, in the panel's pixels.
    static Floating pointerOn(const Pose& panel, const glm::dvec2& px);

  private:
    struct Drawn {
        PanelPicture picture;
        std::uint64_t number = 1;
    };

    void draw(RoomPicture which, PanelPicture picture);

    std::array<Drawn, kRoomPictures> pictures_;
    PanelTexts texts_;  // as drawn on the panel
    std::optional<PanelButton> pointedAt_;
    std::string notice_;
};

// A vibration in a hand.
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
    Box seenMm;             // the visible part, in the world
};

struct RoomFollowed {
    glm::dmat4 stageFromWorld{1.0};
    std::vector<Pulse> pulses = {};
    std::vector<Floating> floating = {};  // later ones lie in front
    double light = 1.0;                   // brightness of everything, 0 to 1
    bool wantsPicture = false;
};

class RoomControls {
  public:
    using Show = ShowRoom;

    RoomControls(RoomHost host, RoomState first);

    // Handles in this order: choices from elsewhere, the panel, a turn, the grasp, tools.
    Result<RoomFollowed> follow(const glm::dmat4& stageFromWorld, const RoomFrame& frame, const Show& show);
    // The anatomy was placed elsewhere: held anatomy does not jump back.
    void takeAnew() { grasp_.takeAnew(); }
    // After a pause without hands: a grasp starts again from their present position, and a cut that was begun
    // is abandoned.
    void interrupt();
    // Call it for a frame without known eye positions.
    void goDark(double seconds) {
        fade_.goDark(seconds);
        interrupt();
    }

    const RoomState& state() const { return choice_.now(); }
    const RoomHost& host() const { return host_; }
    // Shows a sentence before the eyes for some seconds, and passes it to the host. `sentence` names no
    // patient, and is in the host's words.
    void tell(const std::string& sentence);

    // A floating picture. Its number changes when the picture does.
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
    PanelTexts texts_;                // the present ones
    std::string notice_;
    double noticeUntil_ = 0.0;
    double seconds_ = 0.0;
};

}  // namespace macula::xr
