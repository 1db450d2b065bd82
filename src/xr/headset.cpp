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
// The first ones are late because shaders are compiled for them: that says nothing of later ones.
constexpr std::uint64_t kFramesAtFirst = 10;

double msSince(Clock::time_point begun) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
}

// The time since it was asked last.
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

// By how much the larger side of a whole picture is larger than it may be for parts of that size.
double excessOf(const glm::ivec2& wholePx, const glm::ivec2& partPx) {
    constexpr double kMostSides = 2.0;
    return std::max(double(wholePx.x) / partPx.x, double(wholePx.y) / partPx.y) / kMostSides;
}

// A look through the middle of the insets: where a headset that follows the eyes has put them.
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
                              const HeadsetOptions& options) {
    MACULA_TRY(Session session, Session::begin(std::move(runtime), std::move(device), options.session));
    MACULA_TRY(Hands hands, Hands::create(session));
    MACULA_TRY(Lent lent, lend(session, options));
    return Headset(std::move(session), std::move(hands), std::move(lent), view, placed, options.holdsRate);
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
    if (phase == Session::Phase::waiting) return Step::waiting;
    MACULA_TRY(const FrameTime time, session_.beginFrame());
    const Clock::time_point begun = Clock::now();
    times_ = {};
    times_.displayedNs = time.displayed;
    times_.periodMs = time.periodMs;
    times_.waitMs = laps.next();
    times_.level = governor_.level();
    const Result<Views> views = time.shouldRender ? draw(time) : Result<Views>(Views{});
    laps.next();
    const Result<void> submitted = session_.endFrame(time, views ? *views : Views{});
    times_.submitMs = laps.next();
    if (!views) return views.error();
    if (!submitted) return submitted.error();
    times_.isEmpty = views->empty();
    if (times_.isEmpty) return Step::empty;
    const std::shared_ptr<gpu::Device>& device = session_.device();
    MACULA_TRY([[maybe_unused]] const bool isDrawn, device->waitFor(device->submittedTicket()));
    times_.deviceMs = laps.next();
    times_.drawnMs = msSince(begun);
    governor_.notePeriod(time.periodMs);
    if (++framesShown_ > kFramesAtFirst && holdsRate_) governor_.noteFrame(times_.drawnMs);
    MACULA_TRY_VOID(workUntilNext(times_.drawnMs));
    times_.workMs = laps.next();
    return Step::shown;
}

// The other kind of work, where there is no time for the one whose turn it is.
Result<void> Headset::workUntilNext(double begunAgoMs) {
    const Work turn = view_->nextWork();
    for (const Work work : {turn, turn == Work::fovea ? Work::model : Work::fovea}) {
        if (!view_->wants(work)) continue;
        const std::optional<double> budgetMs = timeFor(work, begunAgoMs);
        if (!budgetMs) continue;
        const Clock::time_point begun = Clock::now();
        MACULA_TRY_VOID(view_->work(work, shown_->eyes,
                                    {.budgetMs = *budgetMs,
                                     .gaze = shown_->gaze,
                                     .fineness = shown_->fineness,
                                     .mostSamples = governor_.quality().mostSamples}));
        governor_.noteWork(work, *budgetMs, msSince(begun));
        return {};
    }
    return {};
}

std::optional<double> Headset::timeFor(Work work, double begunAgoMs) {
    if (holdsRate_) return governor_.timeFor(work, begunAgoMs);
    return std::max(Governor::kOurShare * times_.periodMs - begunAgoMs, Governor::kLeastWorkMs);
}

// The eyes are located twice: at first for where the anatomy stands and what hands do to it, and again when
// the headset has lent its images, which may take a while, just before splats are drawn and the fovea is
// warped.
Result<Headset::Views> Headset::draw(const FrameTime& time) {
    Laps laps;
    MACULA_TRY(const Hands::Seen seen, hands_.look(session_, time.displayed));
    MACULA_TRY(const std::vector<Eye> expected, session_.eyesAt(time.displayed));
    if (expected.empty()) return Views{};
    MACULA_TRY_VOID(place(expected, seen.hands));
    MACULA_TRY_VOID(masks_.refresh(session_));
    times_.lookMs = laps.next();
    MACULA_TRY_VOID(acquire());
    times_.lendMs = laps.next();
    MACULA_TRY(const std::vector<Eye> late, session_.eyesAt(time.displayed));
    Shown shown;
    shown.displayed = time.displayed;
    MACULA_TRY(const bool isKnown, aim(late.empty() ? expected : late, seen.gaze, shown));
    if (!isKnown) return Views{};
    MACULA_TRY(Views views, drawFor(shown));
    shown_ = std::move(shown);
    times_.drawMs = laps.next();
    return views;
}

Result<void> Headset::place(const std::vector<Eye>& eyes, const TwoHands& hands) {
    if (session_.wasRecentred()) stageFromWorld_.reset();
    if (!stageFromWorld_) {
        Pose head = eyes[0].pose;
        head.positionM = 0.5 * (eyes[0].pose.positionM + eyes[1].pose.positionM);
        stageFromWorld_ = stageFromWorldBefore(head, view_->seenMm());
    }
    return useHands(hands);
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
        // A part far aside is a small one of a large picture (insets are): coarser, so that not too much is
        // drawn for it.
        const double excess = made ? excessOf(made->sizePx, lent.sizePx()) : 1.0;
        if (excess > 1.0) made = picturesFor(views, worldFromStage, scaled(lent.sizePx(), scale / excess));
        if (!made) {  // a headset that is confused for a moment says so
            log::warning("{}", made.error().message);
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
    if (look) shown.gaze = gazeIn(shown.eyes.centre, shown.eyes.sizePx, worldFromStage, *look);
    return true;
}

Result<Headset::Views> Headset::drawFor(Shown& shown) {
    RoomLook look;
    look.keepsCoverage = session_.blendsByAlpha();
    if (lent_.depths) look.depths = depthRangeOf(*stageFromWorld_);
    MACULA_TRY(RoomPictures drawn, view_->draw(shown.eyes, shown.insets ? &*shown.insets : nullptr, look));
    shown.frame = std::move(drawn.frame);
    const std::span<const gpu::Image* const> pictures(shown.frame.pictures);
    MACULA_TRY(Views views,
               lent_.eyes.show(shown.eyes, pictures.first(kEyes), masks_.partsOf(shown.eyes, 0)));
    if (lent_.insets) {
        MACULA_TRY(const Views insets, lent_.insets->show(*shown.insets, pictures.subspan(kEyes),
                                                          masks_.partsOf(*shown.insets, kEyes)));
        views.insert(views.end(), insets.begin(), insets.end());
    }
    MACULA_TRY_VOID(addDepths(shown, drawn.depths, views));
    return views;
}

Result<void> Headset::addDepths(const Shown& shown, std::span<const gpu::Buffer* const> depths,
                                Views& views) {
    if (depths.empty()) return {};
    const std::span<XrCompositionLayerProjectionView> all(views);
    if (lent_.depths) MACULA_TRY_VOID(lent_.depths->add(shown.eyes, depths.first(kEyes), all.first(kEyes)));
    if (lent_.insetDepths && shown.insets)
        MACULA_TRY_VOID(lent_.insetDepths->add(*shown.insets, depths.subspan(kEyes), all.subspan(kEyes)));
    return {};
}

Result<void> Headset::useHands(const TwoHands& hands) {
    stageFromWorld_ = grasp_.follow(*stageFromWorld_, hands);
    if (const auto kept = grasp_.cut(*stageFromWorld_, hands)) {
        MACULA_TRY([[maybe_unused]] const bool wasCut, view_->cut(*kept));
    }
    return {};
}

}  // namespace macula::xr
