#include "xr/headset.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/log.h"
#include "xr/placement.h"

namespace macula::xr {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kEyes = 2;
// The first frames are late because shaders are compiled: they must not lower the level.
constexpr std::uint64_t kFramesAtFirst = 10;
constexpr XrTime kMirrorEveryNs = 100'000'000;  // of the headset's time

double secondsOf(const FrameTime& time) {
    return double(time.displayed) * 1e-9;
}

double msSince(Clock::time_point begun) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
}

// Measures the time since the last call.
class Laps {
  public:
    double next() {
        const Clock::time_point now = Clock::now();
        const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
        last_ = now;
        return ms;
    }

  private:
    Clock::time_point last_ = Clock::now();
};

glm::ivec2 scaled(const glm::ivec2& sizePx, double scale) {
    return glm::max(glm::ivec2(glm::round(glm::dvec2(sizePx) * scale)), glm::ivec2(2));
}

// The factor by which a whole picture is larger than kMostSides times its part.
double excessOf(const glm::ivec2& wholePx, const glm::ivec2& partPx) {
    constexpr double kMostSides = 2.0;
    return std::max(double(wholePx.x) / partPx.x, double(wholePx.y) / partPx.y) / kMostSides;
}

// The gaze through the middle of the insets, where a headset with eye tracking has placed them.
Pose throughMiddle(std::span<const Eye> insets) {
    glm::dvec3 look(0.0);
    for (const Eye& inset : insets)
        look += glm::normalize(inset.pose.orientation * glm::dvec3(0.5 * (inset.left + inset.right),
                                                                   0.5 * (inset.up + inset.down), -1.0));
    if (!(glm::length(look) > 1e-6)) return insets.front().pose;
    return {insets.front().pose.positionM, glm::dquat(glm::dvec3(0.0, 0.0, -1.0), glm::normalize(look))};
}

double pixelsPerTangent(const EyePictures& pictures) {
    const Eye& eye = pictures.eyes.front().eye;
    return pictures.eyes.front().partPx.x / (eye.right - eye.left);
}

}  // namespace

Result<Headset> Headset::open(std::shared_ptr<Runtime> runtime, std::shared_ptr<gpu::Device> device,
                              RoomView& view, const std::optional<glm::dmat4>& placed,
                              const HeadsetOptions& options, std::shared_ptr<RoomControls> controls) {
    MACULA_TRY(Session session, Session::begin(std::move(runtime), std::move(device), options.session));
    MACULA_TRY(Hands hands, Hands::create(session));
    MACULA_TRY(Lent lent, lend(session, options));
    if (!controls) controls = std::make_shared<RoomControls>(RoomHost{}, view.state());
    controls->interrupt();
    return Headset(std::move(session), std::move(hands), std::move(lent), view, placed, options.holdsRate,
                   std::move(controls));
}

Result<Headset::Lent> Headset::lend(const Session& session, const HeadsetOptions& options) {
    const Offer& offer = session.runtime().offer();
    const bool isChosen = options.eyePx.x >= 2 && options.eyePx.y >= 2;
    const glm::ivec2 eyePx = isChosen ? options.eyePx : offer.eyePx;
    MACULA_TRY(Swapchains eyes, Swapchains::create(session, eyePx));
    Lent lent{std::move(eyes), {}, {}, {}};
    MACULA_TRY(auto depths, DepthLayer::create(session, eyePx));
    if (depths) lent.depths.emplace(std::move(*depths));
    if (!offer.hasInsets) return lent;
    MACULA_TRY(Swapchains insets, Swapchains::create(session, offer.insetPx));
    lent.insets.emplace(std::move(insets));
    MACULA_TRY(auto insetDepths, DepthLayer::create(session, offer.insetPx));
    if (insetDepths) lent.insetDepths.emplace(std::move(*insetDepths));
    return lent;
}

Result<Headset::Step> Headset::step() {
    Laps laps;
    MACULA_TRY(const Session::Phase phase, session_.listen());
    if (phase == Session::Phase::ended) return Step::ended;
    if (phase == Session::Phase::waiting) {
        controls_->interrupt();
        return Step::waiting;
    }
    MACULA_TRY(const FrameTime time, session_.beginFrame());
    const Clock::time_point begun = Clock::now();
    times_ = {};
    times_.displayedNs = time.displayed;
    times_.periodMs = time.periodMs;
    times_.waitMs = laps.next();
    times_.level = governor_.level();
    if (!time.shouldRender) controls_->interrupt();
    const Result<Views> views = time.shouldRender ? draw(time) : Result<Views>(Views{});
    laps.next();
    const Views layers = views ? *views : Views{};
    const Result<void> submitted = session_.endFrame(time, layers.eyes, layers.quads);
    times_.submitMs = laps.next();
    if (!views) return views.error();
    if (!submitted) return submitted.error();
    times_.isEmpty = views->eyes.empty();
    if (times_.isEmpty) return Step::empty;
    const std::shared_ptr<gpu::Device>& device = session_.device();
    MACULA_TRY([[maybe_unused]] const bool isDrawn, device->waitFor(device->submittedTicket()));
    times_.deviceMs = laps.next();
    times_.drawnMs = msSince(begun);
    governor_.notePeriod(time.periodMs);
    // Without the time to show another state, which coarser pictures would not shorten.
    if (++framesShown_ > kFramesAtFirst && holdsRate_) governor_.noteFrame(times_.drawnMs - changesMs_);
    MACULA_TRY_VOID(copyForOthers());
    MACULA_TRY_VOID(workUntilNext(msSince(begun)));
    times_.workMs = laps.next();
    return Step::shown;
}

// Does the other kind of work if there is no time for the one whose turn it is. While it is dark, as in a
// preview of a clip, a late frame is the lesser evil.
Result<void> Headset::workUntilNext(double begunAgoMs) {
    const auto work = [&](Work kind, double budgetMs) {
        return view_->work(kind, shown_->eyes,
                           {.budgetMs = budgetMs,
                            .gaze = shown_->gaze,
                            .fineness = shown_->fineness,
                            .mostSamples = governor_.quality().mostSamples});
    };
    const Work turn = view_->nextWork();
    for (const Work kind : {turn, turn == Work::fovea ? Work::model : Work::fovea}) {
        if (!view_->wants(kind)) continue;
        const std::optional<double> budgetMs = timeFor(kind, begunAgoMs);
        if (!budgetMs) continue;
        const Clock::time_point begun = Clock::now();
        MACULA_TRY_VOID(work(kind, *budgetMs));
        governor_.noteWork(kind, *budgetMs, msSince(begun));
        return {};
    }
    return view_->isDark() ? work(Work::fovea, Governor::kLeastWorkMs) : Result<void>();
}

std::optional<double> Headset::timeFor(Work work, double begunAgoMs) {
    if (holdsRate_) return governor_.timeFor(work, begunAgoMs);
    return std::max(Governor::kOurShare * times_.periodMs - begunAgoMs, Governor::kLeastWorkMs);
}

// Locates the eyes twice: first to place the anatomy and for the hands, and again after the headset has lent
// its images, which may take a while, just before splats are drawn and the fovea is warped. Floating pictures
// stay where the hands were at first; the headset's software composes them over the later pictures.
Result<Headset::Views> Headset::draw(const FrameTime& time) {
    Laps laps;
    changesMs_ = 0.0;
    MACULA_TRY(const Hands::Seen seen, hands_.look(session_, time.displayed));
    bool isTracked = false;
    MACULA_TRY(const std::vector<Eye> expected, session_.eyesAt(time.displayed, &isTracked));
    if (expected.empty()) {
        controls_->goDark(secondsOf(time));
        return Views{};
    }
    MACULA_TRY(const RoomFollowed followed, follow(time, expected, seen.hands, isTracked));
    MACULA_TRY_VOID(masks_.refresh(session_));
    times_.lookMs = laps.next();
    Views views;
    MACULA_TRY(views.quads, quads_.show(session_, *controls_, followed.floating));
    MACULA_TRY_VOID(acquire());
    times_.lendMs = laps.next();
    MACULA_TRY(const std::vector<Eye> late, session_.eyesAt(time.displayed));
    Shown shown;
    shown.displayed = time.displayed;
    MACULA_TRY(const bool isKnown, aim(late.empty() ? expected : late, seen.gaze, shown));
    if (!isKnown) return Views{};
    MACULA_TRY(views.eyes, drawFor(shown, followed.light));
    shown_ = std::move(shown);
    times_.drawMs = laps.next();
    return views;
}

Result<void> Headset::acquire() {
    MACULA_TRY_VOID(lent_.eyes.acquire());
    if (lent_.insets) MACULA_TRY_VOID(lent_.insets->acquire());
    return {};
}

Result<bool> Headset::aim(std::vector<Eye> eyes, const std::optional<Pose>& gaze, Shown& shown) {
    masks_.narrow(eyes);
    const glm::dmat4 worldFromStage = glm::inverse(*stageFromWorld_);
    const double scale = governor_.quality().scale;
    const auto pictured = [&](std::span<const Eye> views, const Swapchains& lent, auto& pictures) {
        auto made = picturesFor(views, worldFromStage, scaled(lent.sizePx(), scale));
        // An off-centre part (as insets are) is a small part of a large symmetric picture: uses fewer pixels,
        // so that not too much is drawn outside it.
        const double excess = made ? excessOf(made->sizePx, lent.sizePx()) : 1.0;
        if (excess > 1.0) made = picturesFor(views, worldFromStage, scaled(lent.sizePx(), scale / excess));
        if (!made) {  // the headset reports an unusable field or pose
            if (!std::exchange(isConfused_, true)) log::warning("{}", made.error().message.english());
            return false;
        }
        pictures = *std::move(made);
        return true;
    };
    const std::span<const Eye> all(eyes);
    if (!pictured(all.first(kEyes), lent_.eyes, shown.eyes)) return false;
    std::optional<Pose> look = gaze;
    if (lent_.insets) {
        const std::span<const Eye> insets = all.subspan(kEyes);
        if (!pictured(insets, *lent_.insets, shown.insets)) return false;
        if (!look) look = throughMiddle(insets);
        shown.fineness = pixelsPerTangent(*shown.insets) / pixelsPerTangent(shown.eyes);
    }
    isConfused_ = false;
    if (look) shown.gaze = gazeIn(shown.eyes.centre, shown.eyes.sizePx, worldFromStage, *look);
    return true;
}

Result<std::vector<XrCompositionLayerProjectionView>> Headset::drawFor(Shown& shown, double light) {
    RoomLook look;
    look.light = light;
    look.keepsCoverage = session_.blendsByAlpha();
    if (lent_.depths && light > 0.0) look.depths = depthRangeOf(*stageFromWorld_);
    view_->setNear(nearMmOf(*stageFromWorld_));
    MACULA_TRY(RoomPictures drawn, view_->draw(shown.eyes, shown.insets ? &*shown.insets : nullptr, look));
    shown.frame = std::move(drawn.frame);
    const std::span<const gpu::Image* const> pictures(shown.frame.pictures);
    MACULA_TRY(auto views, lent_.eyes.show(shown.eyes, pictures.first(kEyes), seenOf(shown.eyes, 0, light)));
    if (lent_.insets) {
        MACULA_TRY(const auto insets, lent_.insets->show(*shown.insets, pictures.subspan(kEyes),
                                                         seenOf(*shown.insets, kEyes, light)));
        views.insert(views.end(), insets.begin(), insets.end());
    }
    MACULA_TRY_VOID(addDepths(shown, drawn.depths, views));
    return views;
}

// The parts of each picture that lenses show. In the dark none, if the real room is visible behind it: black
// pictures would hide the room from a person who has lost orientation.
std::vector<std::vector<VisiblePart>> Headset::seenOf(const EyePictures& pictures, std::size_t firstView,
                                                      double light) {
    if (session_.blendsByAlpha() && !(light > 0.0))
        return std::vector<std::vector<VisiblePart>>(pictures.eyes.size());
    return masks_.partsOf(pictures, firstView);
}

Result<void> Headset::addDepths(const Shown& shown, std::span<const gpu::Buffer* const> depths,
                                std::span<XrCompositionLayerProjectionView> views) {
    if (depths.empty()) return {};
    if (lent_.depths) MACULA_TRY_VOID(lent_.depths->add(shown.eyes, depths.first(kEyes), views.first(kEyes)));
    if (lent_.insetDepths && shown.insets)
        MACULA_TRY_VOID(lent_.insetDepths->add(*shown.insets, depths.subspan(kEyes), views.subspan(kEyes)));
    return {};
}

Result<RoomFollowed> Headset::follow(const FrameTime& time, const std::vector<Eye>& eyes,
                                     const TwoHands& hands, bool isTracked) {
    if (const auto told = writer_->told()) controls_->tell(*told);
    RoomFrame frame;
    frame.seconds = secondsOf(time);
    frame.head = eyes[0].pose;
    frame.head.positionM = 0.5 * (eyes[0].pose.positionM + eyes[1].pose.positionM);
    if (session_.wasRecentred(time.displayed)) stageFromWorld_.reset();
    if (!stageFromWorld_) {
        stageFromWorld_ = stageFromWorldBefore(frame.head, view_->seenMm());
        controls_->takeAnew();
    }
    frame.hands = hands;
    frame.isTracked = isTracked;
    frame.seenMm = view_->seenMm();
    MACULA_TRY(RoomFollowed followed,
               controls_->follow(*stageFromWorld_, frame, [this](const RoomState& state, Lasts lasts) {
                   return change(state, lasts);
               }));
    stageFromWorld_ = followed.stageFromWorld;
    wantsPicture_ = wantsPicture_ || followed.wantsPicture;
    for (const Pulse& pulse : followed.pulses)
        MACULA_TRY_VOID(hands_.pulse(session_, pulse.hand, pulse.strength, pulse.ms));
    return followed;
}

Result<bool> Headset::change(const RoomState& state, Lasts lasts) {
    const Clock::time_point begun = Clock::now();
    auto changed = view_->show(state, lasts);
    changesMs_ += msSince(begun);
    return changed;
}

// Mirrors a few times a second, and copies a picture when the wearer takes one; one copy at a time.
Result<void> Headset::copyForOthers() {
    const RoomHost& host = controls_->host();
    if (auto view = copy_.take()) {
        if (copiesForPicture_) {
            writer_->start(*view, host.pictures, host.words);
            wantsPicture_ = copiesForPicture_ = false;
        }
        if (host.mirror) host.mirror(*std::move(view));
    }
    if (copy_.isUnderWay()) return {};
    const bool isForPicture = wantsPicture_ && !host.pictures.empty() && !writer_->isBusy();
    const bool isForMirror = host.mirror && shown_->displayed - mirroredAt_ >= kMirrorEveryNs;
    if (!isForPicture && !isForMirror) return {};
    mirroredAt_ = shown_->displayed;
    copiesForPicture_ = isForPicture;
    return copy_.begin(*shown_->frame.pictures.front(), shown_->eyes.eyes.front());
}

}  // namespace macula::xr
