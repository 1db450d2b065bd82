#include "xr/panel_pointer.h"

#include <utility>

namespace macula::xr {

std::optional<PanelButton> PanelPointer::follow(const TwoHands& hands, const glm::dvec3& headM, bool isBusy,
                                                const PanelTexts& texts) {
    const Hand& hand = hands[pointingHand()];
    const Hand& wrist = hands[panelHand_];
    panel_.reset();
    if (wrist.grip) {
        const Pose at = WristPanel::poseAt(*wrist.grip);
        if (WristPanel::isTurnedTo(at, headM)) panel_ = at;
    }
    hit_ = panel_ && hand.aim && !isBusy ? WristPanel::hit(*panel_, *hand.aim) : std::nullopt;
    const std::optional<PanelButton> before =
        std::exchange(pointedAt_, hit_ ? WristPanel::buttonAt(*hit_) : std::optional<PanelButton>());
    if (pointedAt_ && !WristPanel::isOffered(*pointedAt_, texts)) pointedAt_.reset();
    const bool wasPressed = std::exchange(isPressed_, holdsOn(hand.press, isPressed_));
    if (isPressed_ && !wasPressed && hit_) isOfPanel_ = true;
    if (!isPressed_ || wasPressed) return std::nullopt;
    // Only if the ray was on the button before the press, so that a sweep over it presses nothing.
    return before == pointedAt_ ? pointedAt_ : std::nullopt;
}

TwoHands PanelPointer::handsBeside(const TwoHands& hands) {
    TwoHands left = hands;
    Hand& pointing = left[pointingHand()];
    const bool isDown = isPressed_ || holdsOn(pointing.trigger, true) || holdsOn(pointing.squeeze, true);
    if (!isDown) isOfPanel_ = false;
    if (isOfPanel_ || hit_) pointing.trigger = pointing.squeeze = 0.0f;
    return left;
}

void PanelPointer::moveToOtherWrist() {
    panelHand_ = pointingHand();
    hit_.reset();
    pointedAt_.reset();
}

}  // namespace macula::xr
