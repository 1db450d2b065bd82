#include "xr/room_controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "xr/placement.h"
#include "xr/room_choice.h"

namespace macula::xr {

namespace {

constexpr glm::ivec2 kNoticePx{640, 40};
constexpr glm::dvec2 kNoticeM{0.64, 0.04};
constexpr glm::dvec3 kNoticeFromHeadM{0.0, -0.22, -0.9};
constexpr double kPointerM = 0.012;

constexpr PanelColour kClear{0, 0, 0, 0};
constexpr PanelColour kNoticeBack{24, 28, 34, 200};
constexpr PanelColour kWhite{235, 238, 242, 255};
constexpr PanelColour kPointer{255, 190, 60, 255};
constexpr PanelColour kOutline{255, 120, 60, 230};
constexpr PanelColour kCutAway{255, 120, 60, 40};

PanelPicture tile() {
    PanelPicture picture(glm::ivec2(128), kCutAway);
    picture.frame({0, 0}, glm::ivec2(128), 3, kOutline);
    return picture;
}

PanelPicture ring() {
    PanelPicture picture(glm::ivec2(128), kClear);
    picture.ring(glm::dvec2(64.0), 0.0, 63.0, kCutAway);
    picture.ring(glm::dvec2(64.0), 60.0, 63.5, kOutline);
    return picture;
}

PanelPicture pointer() {
    PanelPicture picture(glm::ivec2(32), kClear);
    picture.ring(glm::dvec2(16.0), 0.0, 15.0, kPointer);
    return picture;
}

constexpr double kNoticeSeconds = 4.0;

constexpr Pulse kFeelsGrasp{.hand = 0, .strength = 0.4f, .ms = 20.0};
constexpr Pulse kFeelsCut{.hand = 0, .strength = 0.6f, .ms = 30.0};
constexpr Pulse kFeelsPress{.hand = 0, .strength = 0.8f, .ms = 15.0};

Pulse in(std::size_t hand, Pulse pulse) {
    pulse.hand = hand;
    return pulse;
}

}  // namespace

FloatingPictures::FloatingPictures()
    : pictures_{Drawn{PanelPicture(WristPanel::kSizePx, kClear)}, Drawn{PanelPicture(kNoticePx, kClear)},
                Drawn{pointer()}, Drawn{tile()}, Drawn{ring()}} {}

void FloatingPictures::draw(RoomPicture which, PanelPicture picture) {
    Drawn& drawn = pictures_.at(std::size_t(which));
    drawn.picture = std::move(picture);
    ++drawn.number;
}

void FloatingPictures::drawPanel(const PanelTexts& texts, const RoomWords& words,
                                 std::optional<PanelButton> pointedAt) {
    if (texts == texts_ && pointedAt_ == pointedAt) return;
    draw(RoomPicture::panel, WristPanel::draw(texts, words, pointedAt));
    texts_ = texts;
    pointedAt_ = pointedAt;
}

void FloatingPictures::drawNotice(const std::string& text) {
    if (text == notice_) return;
    PanelPicture picture(kNoticePx, kNoticeBack);
    picture.writeInto(text, {8, 0}, {kNoticePx.x - 16, kNoticePx.y}, 2, kWhite);
    draw(RoomPicture::notice, std::move(picture));
    notice_ = text;
}

Floating FloatingPictures::noticeBefore(const Pose& head) {
    const glm::dvec3 at = head.positionM + head.orientation * kNoticeFromHeadM;
    return {RoomPicture::notice, {at, head.orientation}, kNoticeM};
}

Floating FloatingPictures::pointerOn(const Pose& panel, const glm::dvec2& px) {
    return {RoomPicture::pointer, WristPanel::poseOf(panel, px), glm::dvec2(kPointerM)};
}

RoomControls::RoomControls(RoomHost host, RoomState first)
    : host_(std::move(host)), choice_(std::move(first)) {}

void RoomControls::tell(const std::string& sentence) {
    notice_ = sentence;
    noticeUntil_ = seconds_ + kNoticeSeconds;
    texts_.news = sentence;
    if (host_.note) host_.note(sentence);
}

void RoomControls::interrupt() {
    grasp_.takeAnew();
    for (HeldTool& tool : tools_) tool.waitForRelease();
    pointer_.interrupt();
}

ClipTool RoomControls::toolOf(std::size_t hand) const {
    if (hand == panelHand()) return held_;
    return hasKnife_ ? ClipTool::knife : ClipTool::none;
}

Result<bool> RoomControls::change(RoomState next, const Show& show) {
    MACULA_TRY(const bool isShown, choice_.change(std::move(next), host_, show));
    if (!isShown) tell(words().nothingLeft);
    return isShown;
}

std::string RoomControls::sizeText(double scale) const {
    if (!host_.isCalibrated) return words().notCalibrated;
    if (std::abs(scale - 1.0) < 0.005) return words().realSize;
    const double times = scale >= 1.0 ? scale : 1.0 / scale;
    return filled(scale >= 1.0 ? words().larger : words().smaller,
                  words().ofNumber(fmt::format("{:.2f}", times)));
}

Result<RoomFollowed> RoomControls::follow(const glm::dmat4& stageFromWorld, const RoomFrame& frame,
                                          const Show& show) {
    seconds_ = frame.seconds;
    noticeUntil_ = std::min(noticeUntil_, seconds_ + kNoticeSeconds);  // each session has its own clock
    RoomFollowed followed;
    followed.stageFromWorld = stageFromWorld;
    followed.light = fade_.follow(frame.seconds, frame.isTracked);
    MACULA_TRY_VOID(choice_.takeWanted(host_, seconds_, show));
    MACULA_TRY_VOID(usePanel(frame, show, followed));
    const TwoHands hands = pointer_.handsBeside(frame.hands);
    if (const double toTheRightDeg = turns_.follow(hands); toTheRightDeg != 0.0) {
        followed.stageFromWorld = turnedAround(followed.stageFromWorld, frame.head, toTheRightDeg);
        grasp_.takeAnew();
    }
    grasp(frame, hands, followed);
    for (std::size_t hand = 0; hand < hands.size(); ++hand)
        MACULA_TRY_VOID(useTool(hand, frame, hands[hand], show, followed));
    showPanel(followed);
    showNotice(frame, followed);
    return followed;
}

Result<void> RoomControls::usePanel(const RoomFrame& frame, const Show& show, RoomFollowed& followed) {
    const std::size_t pointing = pointer_.pointingHand();
    const bool isBusy = grasp_.holds(pointing) || tools_.at(pointing).isHeld();
    const auto pressed = pointer_.follow(frame.hands, frame.head.positionM, isBusy, texts_);
    if (!pressed) return {};
    followed.pulses.push_back(in(pointing, kFeelsPress));
    return press(*pressed, frame, show, followed);
}

Result<void> RoomControls::press(PanelButton button, const RoomFrame& frame, const Show& show,
                                 RoomFollowed& followed) {
    const auto choose = [&](RoomState next) -> Result<void> {
        MACULA_TRY([[maybe_unused]] const bool isShown, change(std::move(next), show));
        return {};
    };
    RoomState next = state();
    switch (button) {
        case PanelButton::presetBefore:
            return choose(withPreset(state(), host_, -1));
        case PanelButton::presetNext:
            return choose(withPreset(state(), host_, 1));
        case PanelButton::shiftLower:
            return choose(withShift(state(), host_, -1));
        case PanelButton::shiftHigher:
            return choose(withShift(state(), host_, 1));
        case PanelButton::knife:
            hasKnife_ = !hasKnife_;
            return {};
        case PanelButton::held:
            held_ = toolAfter(held_);
            return {};
        case PanelButton::resetClips: {
            // Keeps the mask (a hidden table, for example), which was chosen elsewhere.
            Clip clip;
            if (next.clip) clip.mask = next.clip->mask;
            next.clip = clip.isNothing() ? nullptr : std::make_shared<const Clip>(std::move(clip));
            return choose(std::move(next));
        }
        case PanelButton::undo:
            return choice_.undo(host_, show);
        case PanelButton::picture:
            followed.wantsPicture = true;
            return {};
        case PanelButton::quality:
            next.quality = next.quality == RoomQuality::fast       ? RoomQuality::balanced
                           : next.quality == RoomQuality::balanced ? RoomQuality::fine
                                                                   : RoomQuality::fast;
            return choose(std::move(next));
        case PanelButton::realSize:
            followed.stageFromWorld = scaledAbout(
                followed.stageFromWorld, transformPoint(followed.stageFromWorld, frame.seenMm.centre()), 1.0);
            grasp_.takeAnew();
            tell(host_.isCalibrated ? words().isRealSize : words().notCalibrated);
            return {};
        case PanelButton::recentre:
            followed.stageFromWorld = stageFromWorldBefore(frame.head, frame.seenMm);
            grasp_.takeAnew();
            tell(host_.isCalibrated ? words().isBeforeYou : words().notCalibrated);
            return {};
        case PanelButton::otherWrist:
            pointer_.moveToOtherWrist();
            // The hand that pressed the button has the panel now, and must not cut with the same press.
            for (HeldTool& tool : tools_) tool.waitForRelease();
            return {};
    }
    return {};
}

void RoomControls::grasp(const RoomFrame& frame, const TwoHands& hands, RoomFollowed& followed) {
    const std::array<bool, 2> before{grasp_.holds(0), grasp_.holds(1)};
    const double scaleBefore = scaleOf(followed.stageFromWorld);
    followed.stageFromWorld = grasp_.follow(followed.stageFromWorld, hands);
    for (std::size_t hand = 0; hand < before.size(); ++hand)
        if (grasp_.holds(hand) && !before[hand]) followed.pulses.push_back(in(hand, kFeelsGrasp));
    const double scale = scaleOf(followed.stageFromWorld);
    if (std::abs(scale / scaleBefore - 1.0) < 1e-4) return;
    notice_ = sizeText(scale);  // only before the eyes, not to the host
    noticeUntil_ = frame.seconds + kNoticeSeconds;
}

Result<void> RoomControls::useTool(std::size_t hand, const RoomFrame& frame, const Hand& seen,
                                   const Show& show, RoomFollowed& followed) {
    const ClipTool tool = toolOf(hand);
    if (tool == ClipTool::none && !tools_.at(hand).isHeld()) return {};
    switch (tools_.at(hand).follow(frame.seconds, seen)) {
        case HeldTool::Event::nothing:
            break;
        case HeldTool::Event::begun:
            followed.pulses.push_back(in(hand, kFeelsCut));
            break;
        case HeldTool::Event::rested:
            MACULA_TRY_VOID(cut(hand, *seen.grip, Lasts::forALook, show, followed.stageFromWorld));
            break;
        case HeldTool::Event::letGo:
            MACULA_TRY_VOID(cut(hand, *seen.grip, Lasts::forGood, show, followed.stageFromWorld));
            break;
        case HeldTool::Event::abandoned:
            MACULA_TRY_VOID(choice_.comeBack(show));
            break;
    }
    if (!tools_.at(hand).isHeld()) return {};
    for (const OutlinePart& part : outlineOf(tool, *seen.grip, frame.head.positionM, followed.stageFromWorld))
        followed.floating.push_back(
            {part.isRound ? RoomPicture::ring : RoomPicture::tile, part.pose, part.sizeM});
    return {};
}

Result<void> RoomControls::cut(std::size_t hand, const Pose& at, Lasts lasts, const Show& show,
                               const glm::dmat4& stageFromWorld) {
    const auto clip = withTool(state().clip.get(), toolOf(hand), at, stageFromWorld);
    if (!clip) {
        if (lasts == Lasts::forALook) return {};
        if (toolOf(hand) == ClipTool::knife) tell(words().noMoreCuts);
        return choice_.comeBack(show);
    }
    RoomState next = state();
    next.clip = std::make_shared<const Clip>(*clip);
    if (next == state()) return choice_.comeBack(show);
    if (lasts == Lasts::forALook) {
        MACULA_TRY([[maybe_unused]] const bool isShown, show(next, lasts));
        return {};
    }
    MACULA_TRY(const bool isCut, change(std::move(next), show));
    return isCut ? Result<void>() : choice_.comeBack(show);
}

void RoomControls::showPanel(RoomFollowed& followed) {
    PanelTexts texts = texts_;
    if (!(seconds_ < noticeUntil_)) texts.news.clear();
    const TransferFunction& preset = *state().transferFunction;
    texts.preset = preset.title.empty() ? preset.name : words().ofTitle(preset.title);
    texts.shift = shiftText(state(), host_);
    texts.knife = hasKnife_ ? words().knifeOn : words().knifeOff;
    texts.held = filled(words().hold, words().of(held_));
    texts.quality = filled(words().quality, words().of(state().quality));
    texts.size = sizeText(scaleOf(followed.stageFromWorld));
    texts.canUndo = choice_.canUndo();
    texts.canTakePictures = !host_.pictures.empty();
    texts_ = std::move(texts);
    const std::optional<Pose>& panel = pointer_.panel();
    if (!panel) return;
    pictures_.drawPanel(texts_, words(), pointedAt());
    followed.floating.push_back({RoomPicture::panel, *panel, WristPanel::kSizeM});
    if (pointer_.hit()) followed.floating.push_back(FloatingPictures::pointerOn(*panel, *pointer_.hit()));
}

void RoomControls::showNotice(const RoomFrame& frame, RoomFollowed& followed) {
    if (fade_.isLost()) {
        notice_ = words().lostPlace;
        noticeUntil_ = frame.seconds + 1.0;
    }
    if (notice_.empty() || !(frame.seconds < noticeUntil_)) return;
    pictures_.drawNotice(notice_);
    followed.floating.push_back(FloatingPictures::noticeBefore(frame.head));
}

}  // namespace macula::xr
