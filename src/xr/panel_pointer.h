// A hand that points at the panel at the other wrist, and presses its buttons. Knows no OpenXR.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>

#include "xr/grasp.h"
#include "xr/wrist_panel.h"

namespace macula::xr {

// From frame to frame.
class PanelPointer {
  public:
    // Finds the panel, and what the ray of the pointing hand meets. Returns the button that is pressed in
    // this frame. `isBusy`: the pointing hand holds the anatomy or cuts, and does not press by the way.
    std::optional<PanelButton> follow(const TwoHands& hands, const glm::dvec3& headM, bool isBusy,
                                      const PanelTexts& texts);
    // Hands as all but the panel see them. What is pressed on the panel neither cuts nor grabs, until it is
    // let go, wherever the ray is then. After follow().
    TwoHands handsBeside(const TwoHands& hands);

    void moveToOtherWrist();
    // Nobody has looked for a while: the next press needs the ray on the button anew.
    void interrupt() { pointedAt_.reset(); }

    std::size_t panelHand() const { return panelHand_; }
    std::size_t pointingHand() const { return 1 - panelHand_; }
    // In this frame.
    const std::optional<Pose>& panel() const { return panel_; }
    const std::optional<glm::dvec2>& hit() const { return hit_; }  // of the ray, in pixels of the panel
    std::optional<PanelButton> pointedAt() const { return pointedAt_; }

  private:
    std::size_t panelHand_ = 0;
    std::optional<Pose> panel_;
    std::optional<glm::dvec2> hit_;
    std::optional<PanelButton> pointedAt_;
    bool isPressed_ = false;
    bool isOfPanel_ = false;  // what the pointing hand holds down was pressed on the panel
};

}  // namespace macula::xr
