// The panel at the wrist: its contents, its looks, which button a ray meets, and the hand that points at it.
// Knows no OpenXR.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>

#include "xr/eyes.h"
#include "xr/grasp.h"
#include "xr/panel_picture.h"
#include "xr/room_words.h"

namespace macula::xr {

enum class PanelButton {
    presetBefore,
    presetNext,
    shiftLower,
    shiftHigher,
    knife,
    held,
    resetClips,
    undo,
    picture,
    quality,
    realSize,
    recentre,
    otherWrist,
};

// The texts on the panel that change.
struct PanelTexts {
    std::string preset;
    std::string shift;    // "Shift +20 HU"
    std::string knife;    // "Knife: on"
    std::string held;     // "Hold: ball"
    std::string quality;  // "Quality: balanced"
    std::string size;     // "Real size 1:1"
    std::string news;     // the result of the last press
    bool canUndo = false;
    bool canTakePictures = false;

    bool operator==(const PanelTexts&) const = default;
};

class WristPanel {
  public:
    static constexpr glm::ivec2 kSizePx{400, 480};
    static constexpr glm::dvec2 kSizeM{0.20, 0.24};

    // Where it floats above the wrist of a hand with this grip: x to the right, y up, readable from its +z.
    static Pose poseAt(const Pose& grip);
    // Whether the panel faces the head. It is shown only then, so that it does not stand before the anatomy.
    static bool isTurnedTo(const Pose& panel, const glm::dvec3& headM);
    // Where the ray along -z of `aim` meets the panel's front, in pixels from the upper left corner; nothing
    // beside it, from behind, or more than 1.5 m away.
    static std::optional<glm::dvec2> hit(const Pose& panel, const Pose& aim);
    static Pose poseOf(const Pose& panel, const glm::dvec2& px);  // just in front of it

    static std::optional<PanelButton> buttonAt(const glm::dvec2& px);
    static glm::dvec2 middleOf(PanelButton button);  // in pixels

    // Whether the button can be pressed now.
    static bool isOffered(PanelButton button, const PanelTexts& texts);
    static PanelPicture draw(const PanelTexts& texts, const RoomWords& words,
                             std::optional<PanelButton> pointedAt);
};

// Lets a hand point at the panel on the other wrist and press its buttons. Call follow() in each frame.
class PanelPointer {
  public:
    // Finds the panel, and the button that the ray of the pointing hand meets. Returns the button pressed in
    // this frame. `isBusy`: the pointing hand holds the anatomy or cuts, and must not press by accident.
    std::optional<PanelButton> follow(const TwoHands& hands, const glm::dvec3& headM, bool isBusy,
                                      const PanelTexts& texts);
    // The hands for everything except the panel. A press on the panel neither cuts nor grabs until it is
    // released, wherever the ray is then. Call it after follow().
    TwoHands handsBeside(const TwoHands& hands);

    void moveToOtherWrist();
    // Call it after a pause: the next press needs the ray on the button again.
    void interrupt() { pointedAt_.reset(); }

    std::size_t panelHand() const { return panelHand_; }
    std::size_t pointingHand() const { return 1 - panelHand_; }
    // The panel's pose in this frame.
    const std::optional<Pose>& panel() const { return panel_; }
    const std::optional<glm::dvec2>& hit() const { return hit_; }  // where the ray meets the panel, in pixels
    std::optional<PanelButton> pointedAt() const { return pointedAt_; }

  private:
    std::size_t panelHand_ = 0;
    std::optional<Pose> panel_;
    std::optional<glm::dvec2> hit_;
    std::optional<PanelButton> pointedAt_;
    bool isPressed_ = false;
    bool isOfPanel_ = false;  // the pointing hand's press began on the panel
};

}  // namespace macula::xr
