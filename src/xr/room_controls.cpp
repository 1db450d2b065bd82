#include "xr/room_controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "scene/transfer/edited_transfer.h"
#include "scene/transfer/own_copy.h"
#include "xr/placement.h"

namespace macula::xr {

namespace {

constexpr double kNoticeSeconds = 4.0;
constexpr double kWantedEveryS = 0.25;
constexpr double kDragGoesOnS = 1.0;
constexpr glm::ivec2 kNoticePx{640, 40};
constexpr glm::dvec2 kNoticeM{0.64, 0.04};
constexpr glm::dvec3 kNoticeFromHeadM{0.0, -0.22, -0.9};
constexpr double kPointerM = 0.012;
constexpr double kShiftShare = 0.02;  // of what lies between the first and the last point of the opacity

constexpr PanelColour kClear{0, 0, 0, 0};
constexpr PanelColour kNoticeBack{24, 28, 34, 200};
constexpr PanelColour kWhite{235, 238, 242, 255};
constexpr PanelColour kPointer{255, 190, 60, 255};
constexpr PanelColour kOutline{255, 120, 60, 230};
constexpr PanelColour kCutAway{255, 120, 60, 40};

constexpr Pulse kFeelsGrasp{.hand = 0, .strength = 0.4f, .ms = 20.0};
constexpr Pulse kFeelsCut{.hand = 0, .strength = 0.6f, .ms = 30.0};
constexpr Pulse kFeelsPress{.hand = 0, .strength = 0.8f, .ms = 15.0};

Pulse in(std::size_t hand, Pulse pulse) {
    pulse.hand = hand;
    return pulse;
}

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

}  // namespace

RoomControls::RoomControls(RoomHost host, RoomState first)
    : host_(std::move(host)),
      history_(std::move(first)),
      pictures_{Drawn{PanelPicture(WristPanel::kSizePx, kClear)}, Drawn{PanelPicture(kNoticePx, kClear)},
                Drawn{pointer()}, Drawn{tile()}, Drawn{ring()}} {}

void RoomControls::draw(RoomPicture which, PanelPicture picture) {
    Drawn& drawn = pictures_.at(std::size_t(which));
    drawn.picture = std::move(picture);
    ++drawn.number;
}

void RoomControls::tell(const std::string& sentence) {
    notice_ = sentence;
    noticeUntil_ = seconds_ + kNoticeSeconds;
    texts_.news = sentence;
    if (host_.note) host_.note(sentence);
}

void RoomControls::interrupt() {
    grasp_.takeAnew();
    for (HeldTool& tool : tools_) tool.waitForRelease();
    pointedAt_.reset();
}

ClipTool RoomControls::toolOf(std::size_t hand) const {
    if (hand == panelHand_) return held_;
    return hasKnife_ ? ClipTool::knife : ClipTool::none;
}

Result<bool> RoomControls::change(RoomState next, const Show& show) {
    if (next == state()) return true;
    MACULA_TRY(const bool isShown, show(next, Lasts::forGood));
    if (!isShown) {
        tell(words().nothingLeft);
        return false;
    }
    history_.push(std::move(next));
    wasWanted_ = false;
    if (host_.changed) host_.changed(state());
    return true;
}

Result<void> RoomControls::undo(const Show& show) {
    if (!history_.canUndo()) return {};
    MACULA_TRY(const bool isShown, show(history_.before(), Lasts::forGood));
    if (!isShown) return {};
    history_.undo();
    wasWanted_ = false;
    if (host_.changed) host_.changed(state());
    return {};
}

Result<void> RoomControls::takeWanted(const Show& show) {
    // A hand in the window that drags is followed in steps, which are one to be undone.
    if (!host_.wanted || std::abs(seconds_ - wantedAt_) < kWantedEveryS) return {};
    std::optional<RoomState> wanted = host_.wanted();
    if (!wanted) return {};
    const bool goesOn = wasWanted_ && std::abs(seconds_ - wantedAt_) < kDragGoesOnS;
    wantedAt_ = seconds_;
    wanted->quality = state().quality;  // of the headset alone
    if (!wanted->transferFunction || *wanted == state()) return {};
    MACULA_TRY(const bool isShown, show(*wanted, Lasts::forGood));
    if (!isShown) return {};
    if (goesOn && history_.canUndo()) history_.undo();
    history_.push(*std::move(wanted));
    wasWanted_ = true;
    return {};
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
    noticeUntil_ = std::min(noticeUntil_, seconds_ + kNoticeSeconds);  // a new session has its own time
    RoomFollowed followed;
    followed.stageFromWorld = stageFromWorld;
    followed.light = fade_.follow(frame.seconds, frame.isTracked);
    MACULA_TRY_VOID(takeWanted(show));
    MACULA_TRY_VOID(usePanel(frame, show, followed));
    const TwoHands hands = handsBesidePanel(frame.hands);
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
    const std::size_t pointing = 1 - panelHand_;
    const Hand& hand = frame.hands[pointing];
    const Hand& wrist = frame.hands[panelHand_];
    panel_.reset();
    if (wrist.grip) {
        const Pose at = WristPanel::poseAt(*wrist.grip);
        if (WristPanel::isTurnedTo(at, frame.head.positionM)) panel_ = at;
    }
    // Who holds the anatomy, or cuts, does not press by the way.
    const bool isBusy = grasp_.holds(pointing) || tools_.at(pointing).isHeld();
    hit_ = panel_ && hand.aim && !isBusy ? WristPanel::hit(*panel_, *hand.aim) : std::nullopt;
    const std::optional<PanelButton> before =
        std::exchange(pointedAt_, hit_ ? WristPanel::buttonAt(*hit_) : std::optional<PanelButton>());
    if (pointedAt_ && !WristPanel::isOffered(*pointedAt_, texts_)) pointedAt_.reset();
    const bool wasPressed = std::exchange(isPressed_, holdsOn(hand.press, isPressed_));
    if (isPressed_ && !wasPressed && hit_) isOfPanel_ = true;
    if (!isPressed_ || wasPressed || !pointedAt_) return {};
    // The ray was on the button before it was pressed: nothing happens by a sweep.
    if (before != pointedAt_) return {};
    followed.pulses.push_back(in(pointing, kFeelsPress));
    return press(*pointedAt_, frame, show, followed);
}

// What is pressed on the panel neither cuts nor grabs, until it is let go, wherever the ray is then.
TwoHands RoomControls::handsBesidePanel(const TwoHands& hands) {
    TwoHands left = hands;
    Hand& pointing = left[1 - panelHand_];
    const bool isDown = isPressed_ || holdsOn(pointing.trigger, true) || holdsOn(pointing.squeeze, true);
    if (!isDown) isOfPanel_ = false;
    if (isOfPanel_ || hit_) pointing.trigger = pointing.squeeze = 0.0f;
    return left;
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
            return choose(withPreset(-1));
        case PanelButton::presetNext:
            return choose(withPreset(1));
        case PanelButton::shiftLower:
            return choose(withShift(-1));
        case PanelButton::shiftHigher:
            return choose(withShift(1));
        case PanelButton::knife:
            hasKnife_ = !hasKnife_;
            return {};
        case PanelButton::held:
            held_ = held_ == ClipTool::none   ? ClipTool::ball
                    : held_ == ClipTool::ball ? ClipTool::box
                                              : ClipTool::none;
            return {};
        case PanelButton::resetClips: {
            // What hides voxels, as a table, was chosen elsewhere.
            Clip clip;
            if (next.clip) clip.mask = next.clip->mask;
            next.clip = clip.isNothing() ? nullptr : std::make_shared<const Clip>(std::move(clip));
            return choose(std::move(next));
        }
        case PanelButton::undo:
            return undo(show);
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
            panelHand_ = 1 - panelHand_;
            // It was pressed by the hand that has the panel now, and cuts nothing with it.
            for (HeldTool& tool : tools_) tool.waitForRelease();
            hit_.reset();
            pointedAt_.reset();
            return {};
    }
    return {};
}

std::optional<std::size_t> RoomControls::presetIndex() const {
    const TransferFunction& now = *state().transferFunction;
    const std::string copied = scene::copiedFrom(now);
    const std::string& name = copied.empty() ? now.name : copied;
    for (std::size_t i = 0; i < host_.presets.size(); ++i)
        if (host_.presets[i]->name == name) return i;
    return std::nullopt;
}

RoomState RoomControls::withPreset(int steps) const {
    RoomState next = state();
    const int count = int(host_.presets.size());
    if (count == 0) return next;
    const auto index = presetIndex();
    // One that is not in the list stands before the first.
    const int at = index ? int(*index) + steps : (steps > 0 ? 0 : count - 1);
    next.transferFunction = host_.presets[std::size_t((at % count + count) % count)];
    return next;
}

RoomState RoomControls::withShift(int steps) const {
    RoomState next = state();
    const TransferFunction& now = *next.transferFunction;
    if (now.opacity.empty()) return next;
    const double across = now.opacity.back().value - now.opacity.front().value;
    if (!(across > 0.0)) return next;
    TransferFunction moved = scene::shifted(now, steps * kShiftShare * across);
    if (scene::copiedFrom(moved).empty()) {
        std::set<std::string> taken;
        for (const auto& preset : host_.presets) taken.insert(preset->name);
        moved = scene::ownCopy(moved, taken);
    }
    next.transferFunction = std::make_shared<const TransferFunction>(std::move(moved));
    return next;
}

std::string RoomControls::shiftText() const {
    const TransferFunction& now = *state().transferFunction;
    const auto index = presetIndex();
    if (!index || now.opacity.empty() || host_.presets[*index]->opacity.empty()) return words().shift;
    const double across = now.opacity.back().value - now.opacity.front().value;
    double by = now.opacity.front().value - host_.presets[*index]->opacity.front().value;
    if (std::abs(by) < 1e-9 * across) by = 0.0;  // rounding, of steps to and fro
    // Three digits, but no power of ten: "+1040", and not "+1.04e+03".
    const std::string number =
        std::abs(by) < 999.5 ? fmt::format("{:+.3g}", by + 0.0) : fmt::format("{:+.0f}", by);
    return fmt::format("{} {}{}", words().shift, words().ofNumber(number),
                       now.unit == Unit::hounsfield ? " HU" : "");
}

void RoomControls::grasp(const RoomFrame& frame, const TwoHands& hands, RoomFollowed& followed) {
    const std::array<bool, 2> before{grasp_.holds(0), grasp_.holds(1)};
    const double scaleBefore = scaleOf(followed.stageFromWorld);
    followed.stageFromWorld = grasp_.follow(followed.stageFromWorld, hands);
    for (std::size_t hand = 0; hand < before.size(); ++hand)
        if (grasp_.holds(hand) && !before[hand]) followed.pulses.push_back(in(hand, kFeelsGrasp));
    const double scale = scaleOf(followed.stageFromWorld);
    if (std::abs(scale / scaleBefore - 1.0) < 1e-4) return;
    notice_ = sizeText(scale);  // for the eyes alone, while it grows
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
        case HeldTool::Event::abandoned: {
            MACULA_TRY([[maybe_unused]] const bool isShown, show(state(), Lasts::forGood));
            break;
        }
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
    // What was gone for a look comes back where nothing stays gone.
    const auto comeBack = [&]() -> Result<void> {
        MACULA_TRY([[maybe_unused]] const bool isShown, show(state(), Lasts::forGood));
        return {};
    };
    if (!clip) {
        if (lasts == Lasts::forALook) return {};
        if (toolOf(hand) == ClipTool::knife) tell(words().noMoreCuts);
        return comeBack();
    }
    RoomState next = state();
    next.clip = std::make_shared<const Clip>(*clip);
    if (next == state()) return comeBack();
    if (lasts == Lasts::forALook) {
        MACULA_TRY([[maybe_unused]] const bool isShown, show(next, lasts));
        return {};
    }
    MACULA_TRY(const bool isCut, change(std::move(next), show));
    return isCut ? Result<void>() : comeBack();
}

void RoomControls::showPanel(RoomFollowed& followed) {
    PanelTexts texts = texts_;
    if (!(seconds_ < noticeUntil_)) texts.news.clear();
    const TransferFunction& preset = *state().transferFunction;
    texts.preset = preset.title.empty() ? preset.name : words().ofTitle(preset.title);
    texts.shift = shiftText();
    texts.knife = hasKnife_ ? words().knifeOn : words().knifeOff;
    texts.held = filled(words().hold, words().of(held_));
    texts.quality = filled(words().quality, words().of(state().quality));
    texts.size = sizeText(scaleOf(followed.stageFromWorld));
    texts.canUndo = history_.canUndo();
    texts.canTakePictures = !host_.pictures.empty();
    texts_ = std::move(texts);
    if (!panel_) return;
    if (!(texts_ == drawnTexts_) || drawnPointedAt_ != pointedAt_) {
        draw(RoomPicture::panel, WristPanel::draw(texts_, words(), pointedAt_));
        drawnTexts_ = texts_;
        drawnPointedAt_ = pointedAt_;
    }
    followed.floating.push_back({RoomPicture::panel, *panel_, WristPanel::kSizeM});
    if (hit_)
        followed.floating.push_back(
            {RoomPicture::pointer, WristPanel::poseOf(*panel_, *hit_), glm::dvec2(kPointerM)});
}

void RoomControls::showNotice(const RoomFrame& frame, RoomFollowed& followed) {
    if (fade_.isLost()) {
        notice_ = words().lostPlace;
        noticeUntil_ = frame.seconds + 1.0;
    }
    if (notice_.empty() || !(frame.seconds < noticeUntil_)) return;
    if (notice_ != drawnNotice_) {
        PanelPicture picture(kNoticePx, kNoticeBack);
        picture.writeInto(notice_, {8, 0}, {kNoticePx.x - 16, kNoticePx.y}, 2, kWhite);
        draw(RoomPicture::notice, std::move(picture));
        drawnNotice_ = notice_;
    }
    const glm::dvec3 at = frame.head.positionM + frame.head.orientation * kNoticeFromHeadM;
    followed.floating.push_back({RoomPicture::notice, {at, frame.head.orientation}, kNoticeM});
}

}  // namespace macula::xr
