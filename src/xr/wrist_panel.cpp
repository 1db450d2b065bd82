#include "xr/wrist_panel.h"

#include <array>
#include <utility>

#include "base/check.h"

namespace macula::xr {

namespace {

constexpr double kReachM = 1.5;
constexpr double kFacesFromCosine = 0.35;  // about 70 degrees to the side
// In the coordinates of a grip: its -z goes up through the fist, its +y back along the arm.
constexpr glm::dvec3 kFromGripM{0.0, 0.06, -0.15};
constexpr double kBeforeM = 0.002;

constexpr PanelColour kBack{24, 28, 34, 235};
constexpr PanelColour kEdge{120, 130, 145, 255};
constexpr PanelColour kButton{52, 60, 72, 255};
constexpr PanelColour kPointedAt{70, 120, 190, 255};
constexpr PanelColour kText{235, 238, 242, 255};
constexpr PanelColour kFaint{120, 126, 134, 255};
constexpr int kRowPx = 44;

struct Place {
    PanelButton button;
    glm::ivec2 fromPx;
    glm::ivec2 sizePx;
};

// Rows from the top, with a gap of 8 pixels.
constexpr std::array kPlaces{
    Place{PanelButton::presetBefore, {8, 44}, {52, kRowPx}},
    Place{PanelButton::presetNext, {340, 44}, {52, kRowPx}},
    Place{PanelButton::shiftLower, {8, 96}, {52, kRowPx}},
    Place{PanelButton::shiftHigher, {340, 96}, {52, kRowPx}},
    Place{PanelButton::knife, {8, 148}, {188, kRowPx}},
    Place{PanelButton::held, {204, 148}, {188, kRowPx}},
    Place{PanelButton::resetClips, {8, 200}, {188, kRowPx}},
    Place{PanelButton::undo, {204, 200}, {188, kRowPx}},
    Place{PanelButton::picture, {8, 252}, {188, kRowPx}},
    Place{PanelButton::otherWrist, {204, 252}, {188, kRowPx}},
    Place{PanelButton::realSize, {8, 304}, {188, kRowPx}},
    Place{PanelButton::recentre, {204, 304}, {188, kRowPx}},
    Place{PanelButton::quality, {8, 356}, {384, kRowPx}},
};

const Place& placeOf(PanelButton button) {
    for (const Place& place : kPlaces)
        if (place.button == button) return place;
    MACULA_CHECK(false);
    return kPlaces.front();
}

std::string textOf(PanelButton button, const PanelTexts& texts, const RoomWords& words) {
    switch (button) {
        case PanelButton::presetBefore:
        case PanelButton::shiftLower:
            return "<";
        case PanelButton::presetNext:
        case PanelButton::shiftHigher:
            return ">";
        case PanelButton::knife:
            return texts.knife;
        case PanelButton::held:
            return texts.held;
        case PanelButton::resetClips:
            return words.resetClips;
        case PanelButton::undo:
            return words.undo;
        case PanelButton::picture:
            return words.takePicture;
        case PanelButton::quality:
            return texts.quality;
        case PanelButton::realSize:
            return words.realSize;
        case PanelButton::recentre:
            return words.recentre;
        case PanelButton::otherWrist:
            return words.otherWrist;
    }
    return {};
}

}  // namespace

Pose WristPanel::poseAt(const Pose& grip) {
    const glm::dquat upright = glm::angleAxis(glm::radians(-90.0), glm::dvec3(1.0, 0.0, 0.0));
    return {grip.positionM + grip.orientation * kFromGripM, glm::normalize(grip.orientation * upright)};
}

bool WristPanel::isTurnedTo(const Pose& panel, const glm::dvec3& headM) {
    const glm::dvec3 towards = headM - panel.positionM;
    const double far = glm::length(towards);
    return far > 0.0 &&
           glm::dot(panel.orientation * glm::dvec3(0.0, 0.0, 1.0), towards) > kFacesFromCosine * far;
}

std::optional<glm::dvec2> WristPanel::hit(const Pose& panel, const Pose& aim) {
    const glm::dquat back = glm::inverse(panel.orientation);
    const glm::dvec3 from = back * (aim.positionM - panel.positionM);
    const glm::dvec3 along = back * (aim.orientation * glm::dvec3(0.0, 0.0, -1.0));
    if (!(from.z > 0.0 && along.z < -1e-6)) return std::nullopt;
    const double far = -from.z / along.z;
    if (!(far <= kReachM)) return std::nullopt;
    const glm::dvec3 at = from + far * along;
    const glm::dvec2 share(at.x / kSizeM.x + 0.5, 0.5 - at.y / kSizeM.y);
    if (!(share.x >= 0.0 && share.x < 1.0 && share.y >= 0.0 && share.y < 1.0)) return std::nullopt;
    return share * glm::dvec2(kSizePx);
}

Pose WristPanel::poseOf(const Pose& panel, const glm::dvec2& px) {
    const glm::dvec2 share = px / glm::dvec2(kSizePx);
    const glm::dvec3 at((share.x - 0.5) * kSizeM.x, (0.5 - share.y) * kSizeM.y, kBeforeM);
    return {panel.positionM + panel.orientation * at, panel.orientation};
}

std::optional<PanelButton> WristPanel::buttonAt(const glm::dvec2& px) {
    for (const Place& place : kPlaces) {
        const glm::dvec2 in = px - glm::dvec2(place.fromPx);
        if (in.x >= 0.0 && in.y >= 0.0 && in.x < place.sizePx.x && in.y < place.sizePx.y) return place.button;
    }
    return std::nullopt;
}

glm::dvec2 WristPanel::middleOf(PanelButton button) {
    const Place& place = placeOf(button);
    return glm::dvec2(place.fromPx) + 0.5 * glm::dvec2(place.sizePx);
}

bool WristPanel::isOffered(PanelButton button, const PanelTexts& texts) {
    if (button == PanelButton::undo) return texts.canUndo;
    if (button == PanelButton::picture) return texts.canTakePictures;
    return true;
}

PanelPicture WristPanel::draw(const PanelTexts& texts, const RoomWords& words,
                              std::optional<PanelButton> pointedAt) {
    PanelPicture picture(kSizePx, kBack);
    picture.frame({0, 0}, kSizePx, 2, kEdge);
    picture.writeInto(texts.size, {8, 8}, {kSizePx.x - 16, 30}, 2, kText);
    for (const Place& place : kPlaces) {
        const bool isOffered = WristPanel::isOffered(place.button, texts);
        const bool isPointedAt = isOffered && pointedAt == place.button;
        picture.fill(place.fromPx, place.sizePx, isPointedAt ? kPointedAt : kButton);
        if (isPointedAt) picture.frame(place.fromPx, place.sizePx, 2, kText);
        picture.writeInto(textOf(place.button, texts, words), place.fromPx, place.sizePx, 2,
                          isOffered ? kText : kFaint);
    }
    picture.writeInto(texts.preset, {64, 44}, {272, kRowPx}, 2, kText);
    picture.writeInto(texts.shift, {64, 96}, {272, kRowPx}, 2, kText);
    picture.writeInto(texts.news, {8, 408}, {kSizePx.x - 16, 30}, 2, kText);
    picture.writeInto(words.notForDiagnosis, {8, 442}, {kSizePx.x - 16, 30}, 2, kFaint);
    return picture;
}

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
