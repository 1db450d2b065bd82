#include "xr/headset.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/log.h"
#include "xr/placement.h"

namespace macula::xr {

namespace {

using Clock = std::chrono::steady_clock;

// Of the time between two frames; the rest is for the runtime, which takes its share of the device.
constexpr double kOurShare = 0.7;
constexpr double kLeastWorkMs = 1.0;
constexpr XrTime kMirrorEveryNs = 100'000'000;  // of the headset's time

double secondsOf(const FrameTime& time) {
    return double(time.displayed) * 1e-9;
}

double msSince(Clock::time_point begun) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
}

}  // namespace

Result<Headset> Headset::open(std::shared_ptr<Runtime> runtime, std::shared_ptr<gpu::Device> device,
                              RoomView& view, const std::optional<glm::dmat4>& placed,
                              std::shared_ptr<RoomControls> controls) {
    MACULA_TRY(Session session, Session::begin(std::move(runtime), std::move(device)));
    MACULA_TRY(Hands hands, Hands::create(session));
    MACULA_TRY(Swapchains swapchains, Swapchains::create(session, session.runtime().offer().eyePx));
    if (!controls) controls = std::make_shared<RoomControls>(RoomHost{}, view.state());
    return Headset(std::move(session), std::move(hands), std::move(swapchains), view, placed,
                   std::move(controls));
}

Result<Headset::Step> Headset::step() {
    MACULA_TRY(const Session::Phase phase, session_.listen());
    if (phase == Session::Phase::ended) return Step::ended;
    if (phase == Session::Phase::waiting) return Step::waiting;
    MACULA_TRY(const FrameTime time, session_.beginFrame());
    const Clock::time_point begun = Clock::now();
    const Result<Views> views = time.shouldRender ? draw(time) : Result<Views>(Views{});
    const Views shown = views ? *views : Views{};
    const Result<void> submitted = session_.endFrame(time, shown.eyes, shown.quads);
    if (!views) return views.error();
    if (!submitted) return submitted.error();
    if (shown.eyes.empty()) return Step::empty;
    const double leftMs = kOurShare * time.periodMs - msSince(begun);
    MACULA_TRY_VOID(view_->work(shown_->eyes, shown_->gaze, std::max(leftMs, kLeastWorkMs)));
    return Step::shown;
}

Result<Headset::Views> Headset::draw(const FrameTime& time) {
    MACULA_TRY(const Hands::Seen seen, hands_.look(session_, time.displayed));
    bool isTracked = false;
    MACULA_TRY(const std::vector<Eye> eyes, session_.eyesAt(time.displayed, &isTracked));
    if (eyes.empty()) {
        controls_->goDark(secondsOf(time));
        return Views{};
    }
    Pose head = eyes.front().pose;
    head.positionM = 0.5 * (eyes.front().pose.positionM + eyes.back().pose.positionM);
    if (session_.wasRecentred()) stageFromWorld_.reset();
    if (!stageFromWorld_) {
        stageFromWorld_ = stageFromWorldBefore(head, view_->seenMm());
        controls_->takeAnew();
    }
    MACULA_TRY(const RoomFollowed followed, follow(time, head, seen.hands, isTracked));
    const glm::dmat4 worldFromStage = glm::inverse(*stageFromWorld_);

    auto pictures = picturesFor(eyes, worldFromStage, swapchains_.sizePx());
    if (!pictures) {  // a headset that is confused for a moment says so
        log::warning("{}", pictures.error().message);
        return Views{};
    }
    Shown shown;
    shown.displayed = time.displayed;
    shown.eyes = *std::move(pictures);
    if (seen.gaze) shown.gaze = gazeIn(shown.eyes.centre, shown.eyes.sizePx, worldFromStage, *seen.gaze);
    view_->setNear(nearMmOf(*stageFromWorld_));
    MACULA_TRY(shown.frame, view_->draw(shown.eyes, followed.light));
    Views views;
    MACULA_TRY(views.eyes, swapchains_.show(shown.eyes, shown.frame.pictures));
    MACULA_TRY(views.quads, quads_.show(session_, *controls_, followed.floating));
    MACULA_TRY_VOID(copyForOthers(time, shown));
    shown_ = std::move(shown);
    return views;
}

Result<RoomFollowed> Headset::follow(const FrameTime& time, const Pose& head, const TwoHands& hands,
                                     bool isTracked) {
    if (const auto told = writer_->told()) controls_->tell(*told);
    RoomFrame frame;
    frame.seconds = secondsOf(time);
    frame.head = head;
    frame.hands = hands;
    frame.isTracked = isTracked;
    frame.seenMm = view_->seenMm();
    MACULA_TRY(RoomFollowed followed,
               controls_->follow(*stageFromWorld_, frame, [this](const RoomState& state, Lasts lasts) {
                   return view_->show(state, lasts);
               }));
    stageFromWorld_ = followed.stageFromWorld;
    wantsPicture_ = wantsPicture_ || followed.wantsPicture;
    for (const Pulse& pulse : followed.pulses)
        MACULA_TRY_VOID(hands_.pulse(session_, pulse.hand, pulse.strength, pulse.ms));
    return followed;
}

// The mirror is a few times a second, a picture when it was asked for; one copy at a time.
Result<void> Headset::copyForOthers(const FrameTime& time, const Shown& shown) {
    const RoomHost& host = controls_->host();
    if (auto view = copy_.take()) {
        if (copiesForPicture_) {
            writer_->start(*view, host.pictures);
            wantsPicture_ = copiesForPicture_ = false;
        }
        if (host.mirror) host.mirror(*std::move(view));
    }
    if (copy_.isUnderWay()) return {};
    const bool isForPicture = wantsPicture_ && !host.pictures.empty() && !writer_->isBusy();
    const bool isForMirror = host.mirror && time.displayed - mirroredAt_ >= kMirrorEveryNs;
    if (!isForPicture && !isForMirror) return {};
    mirroredAt_ = time.displayed;
    copiesForPicture_ = isForPicture;
    return copy_.begin(*shown.frame.pictures.front(), shown.eyes.eyes.front());
}

}  // namespace macula::xr
