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

double msSince(Clock::time_point begun) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
}

}  // namespace

Result<Headset> Headset::open(std::shared_ptr<Runtime> runtime, std::shared_ptr<gpu::Device> device,
                              RoomView& view, const std::optional<glm::dmat4>& placed) {
    MACULA_TRY(Session session, Session::begin(std::move(runtime), std::move(device)));
    MACULA_TRY(Hands hands, Hands::create(session));
    MACULA_TRY(Swapchains swapchains, Swapchains::create(session, session.runtime().offer().eyePx));
    return Headset(std::move(session), std::move(hands), std::move(swapchains), view, placed);
}

Result<Headset::Step> Headset::step() {
    MACULA_TRY(const Session::Phase phase, session_.listen());
    if (phase == Session::Phase::ended) return Step::ended;
    if (phase == Session::Phase::waiting) return Step::waiting;
    MACULA_TRY(const FrameTime time, session_.beginFrame());
    const Clock::time_point begun = Clock::now();
    const Result<Views> views = time.shouldRender ? draw(time) : Result<Views>(Views{});
    const Result<void> submitted = session_.endFrame(time, views ? *views : Views{});
    if (!views) return views.error();
    if (!submitted) return submitted.error();
    if (views->empty()) return Step::empty;
    const double leftMs = kOurShare * time.periodMs - msSince(begun);
    MACULA_TRY_VOID(view_->work(shown_->eyes, shown_->gaze, std::max(leftMs, kLeastWorkMs)));
    return Step::shown;
}

Result<Headset::Views> Headset::draw(const FrameTime& time) {
    MACULA_TRY(const Hands::Seen seen, hands_.look(session_, time.displayed));
    MACULA_TRY(const std::vector<Eye> eyes, session_.eyesAt(time.displayed));
    if (eyes.empty()) return Views{};
    if (session_.wasRecentred()) stageFromWorld_.reset();
    if (!stageFromWorld_) {
        Pose head = eyes.front().pose;
        head.positionM = 0.5 * (eyes.front().pose.positionM + eyes.back().pose.positionM);
        stageFromWorld_ = stageFromWorldBefore(head, view_->seenMm());
    }
    MACULA_TRY_VOID(useHands(seen.hands));
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
    MACULA_TRY(shown.frame, view_->draw(shown.eyes));
    MACULA_TRY(Views views, swapchains_.show(shown.eyes, shown.frame.pictures));
    shown_ = std::move(shown);
    return views;
}

Result<void> Headset::useHands(const TwoHands& hands) {
    stageFromWorld_ = grasp_.follow(*stageFromWorld_, hands);
    if (const auto kept = grasp_.cut(*stageFromWorld_, hands)) {
        MACULA_TRY([[maybe_unused]] const bool wasCut, view_->cut(*kept));
    }
    return {};
}

}  // namespace macula::xr
