// The panel at the wrist: its contents, its looks, and which button a ray meets. Knows no OpenXR.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>

#include "xr/eyes.h"
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

}  // namespace macula::xr
