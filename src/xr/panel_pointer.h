// Lets a hand point at the panel on the other wrist and press its buttons. Knows no OpenXR.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>

#include "xr/grasp.h"
#include "xr/wrist_panel.h"

namespace macula::xr {

// Call follow() in each frame.
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
