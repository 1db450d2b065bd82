// The views of a peripheral model: those it asks for, and those it is offered.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "pipeline/hybrid/model/peripheral_model.h"
#include "pipeline/hybrid/views/coarse_picture.h"
#include "pipeline/hybrid/views/drawn_views.h"
#include "pipeline/hybrid/views/held_out.h"

namespace macula::hybrid {

namespace {

// Bytes on the device for a pixel of a view, with its smaller copies: a third more than LossTarget takes.
constexpr double kBytesOfPixel = 27.0;
constexpr std::size_t kMostAsked = 8;  // views asked for and not offered yet
constexpr std::size_t kLooks = 8;      // candidates that are drawn at a time to see what they show
constexpr int kLookSidePx = 32;
constexpr double kLeastCoverage = 0.04;  // as PoseLimits
// The least coverage that an error is divided by: the error of a view that shows hardly anything is not that
// of its few pixels.
constexpr double kLeastShare = 0.02;

// Of the picture that the window traces while a hand moves and there is no model, on two cores.
constexpr int kCoarseLines = 42;
constexpr int kCoarserThanPicture = 3;  // at least so many times

double coverageOf(const splat::TrainingView& view) {
    return std::max(meanCoverage(view), kLeastShare);
}

}  // namespace

std::vector<KnownPose> PeripheralModel::knownViews() const {
    std::vector<KnownPose> known;
    while (coverage_.size() < trainer_.viewCount())
        coverage_.push_back(coverageOf(trainer_.view(coverage_.size())));
    for (std::size_t i = 0; i < trainer_.viewCount(); ++i) {
        if (trainer_.view(i).kind != splat::ViewKind::picture) continue;  // no picture of it was seen
        known.push_back({.view = trainer_.view(i).view, .error = trainer_.lastDifference(i) / coverage_[i]});
    }
    for (const HeldOut& h : heldOut_) known.push_back({.view = h.picture->view, .error = h.errors.trained});
    for (const Camera& camera : asked_) {
        const auto view =
            splat::rasterView(camera, options_.wanted.sizePx, trainer_.lastGood().splats.originMm);
        if (view) known.push_back({.view = *view});
    }
    return known;
}

Result<std::optional<CandidatePose>> PeripheralModel::wantedView() {
    using Wanted = std::optional<CandidatePose>;
    if (isFull()) return Wanted();
    const std::uint64_t seed = (std::uint64_t(options_.seed) << 32) + notes_.asked;
    MACULA_TRY(std::vector<CandidatePose> wanted,
               candidatePoses(knownViews(), notes_.seenMm, trainer_.lastGood().splats.originMm, seed,
                              options_.wanted));
    MACULA_TRY(const splat::Splats now, trainer_.snapshot());
    const glm::dvec2 size(options_.wanted.sizePx);
    const glm::ivec2 small = glm::max(glm::ivec2(size * (kLookSidePx / std::max(size.x, size.y))), 1);
    const auto ask = [&](const CandidatePose& view) {
        ++notes_.asked;
        asked_.push_back(view.camera);
        if (asked_.size() > kMostAsked) asked_.erase(asked_.begin());
        return Wanted(view);
    };
    // The best candidates are of what no view has seen yet, where there may be nothing: then the next ones
    // are looked at.
    const CandidatePose* fullest = nullptr;
    double most = 0.0;
    std::size_t count = 1;  // mostly the best is right
    for (std::size_t first = 0; first < wanted.size(); first += std::exchange(count, kLooks)) {
        const std::span looks = std::span(wanted).subspan(first, std::min(count, wanted.size() - first));
        std::vector<Camera> cameras;
        std::transform(looks.begin(), looks.end(), std::back_inserter(cameras),
                       [](const CandidatePose& view) { return view.camera; });
        MACULA_TRY(const DrawnViews drawn, drawViews(device_, now, cameras, small));
        for (std::size_t i = 0; i < looks.size(); ++i) {
            const double sum = std::accumulate(drawn.pictures[i].begin(), drawn.pictures[i].end(), 0.0,
                                               [](double s, const glm::vec4& p) { return s + double(p.a); });
            if (now.size() == 0 || sum >= kLeastCoverage * double(drawn.pictures[i].size()))
                return ask(looks[i]);
            if (sum > most) {
                most = sum;
                fullest = &looks[i];
            }
        }
    }
    // A vessel or a nodule covers little of any view.
    if (fullest != nullptr) return ask(*fullest);
    ++notes_.asked;  // others are drawn the next time
    return Wanted();
}

bool PeripheralModel::isFull() const {
    if (trainer_.viewCount() + heldOut_.size() >= options_.mostViews) return true;
    double bytes = 0.0;
    for (std::size_t i = 0; i < trainer_.viewCount(); ++i)
        bytes += kBytesOfPixel * double(trainer_.view(i).pixels.size());
    return bytes > options_.viewsShare * (bytes + double(device_->memoryAvailableBytes()));
}

bool PeripheralModel::isKnown(const splat::RasterView& view) const {
    const double radiusMm = 0.5 * notes_.seenMm.diagonal();
    const auto same = [&](const splat::RasterView& other) {
        return isSamePose(view, other, radiusMm, options_.wanted.admission);
    };
    for (std::size_t i = 0; i < trainer_.viewCount(); ++i)
        if (trainer_.view(i).kind == splat::ViewKind::picture && same(trainer_.view(i).view)) return true;
    return std::any_of(heldOut_.begin(), heldOut_.end(),
                       [&](const HeldOut& h) { return same(h.picture->view); });
}

std::optional<std::size_t> PeripheralModel::learntViewOf(const splat::RasterView& view) const {
    for (std::size_t i = 0; i < trainer_.viewCount(); ++i)
        if (trainer_.view(i).kind == splat::ViewKind::picture && trainer_.view(i).view == view) return i;
    return std::nullopt;
}

double PeripheralModel::degreesBesideHeldOut(const splat::RasterView& view) const {
    const glm::dvec3 centre = notes_.seenMm.centre() - trainer_.lastGood().splats.originMm;
    double least = 180.0;
    for (const HeldOut& h : heldOut_) {
        const glm::dvec3 a = view.eyeMm - centre;
        const glm::dvec3 b = h.picture->view.eyeMm - centre;
        least = std::min(least, glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b))));
    }
    return least;
}

// Judges with a copy of the shown model that is on the device only for that time: pictures are held out
// rarely, and a copy that stayed would take room from the model that learns.
Result<void> PeripheralModel::judgeShown(std::span<HeldOut> heldOut) const {
    if (heldOut.empty()) return {};
    const auto compare = [&](const splat::Splats& splats, double Errors::*error) -> Result<void> {
        splat::TrainerOptions options = notes_.first;
        options.capacity = 0;  // room for as many splats as there are
        const splat::Splats here = relativeTo(splats, trainer_.lastGood().splats.originMm);
        MACULA_TRY(splat::Trainer judge, splat::Trainer::create(device_, here, options));
        for (HeldOut& h : heldOut) {
            MACULA_TRY(const double difference, judge.differenceTo(*h.picture));
            h.errors.*error = difference / h.coverage;
        }
        return {};
    };
    MACULA_TRY_VOID(compare(*shown_, &Errors::shown));
    if (best_ != shown_) return compare(*best_, &Errors::best);
    for (HeldOut& h : heldOut) h.errors.best = h.errors.shown;
    return {};
}

// The shown and the best model are each compared with the new pictures. The trained model must not stand in
// for them: it may have become worse since.
Result<void> PeripheralModel::takeHeldOut(
    std::span<const std::shared_ptr<const splat::TrainingView>> pictures) {
    std::vector<HeldOut> taken;
    for (const auto& picture : pictures) {
        HeldOut& h = taken.emplace_back();
        h.picture = picture;
        h.coverage = coverageOf(*picture);
        MACULA_TRY(const double error, trainer_.differenceTo(*picture));
        h.errors.trained = error / h.coverage;
        const int lines = std::min(kCoarseLines, picture->view.sizePx.y / kCoarserThanPicture);
        h.errors.coarse = coarseDifference(*picture, std::max(lines, 1), notes_.first.loss) / h.coverage;
    }
    MACULA_TRY_VOID(judgeShown(taken));
    heldOut_.insert(heldOut_.end(), taken.begin(), taken.end());
    noteSharpness();
    trend_.forget();
    return {};
}

Result<Offered> PeripheralModel::offer(TracedView view, bool mayBeHeldOut) {
    const glm::dvec3 originMm = trainer_.lastGood().splats.originMm;
    const double radiusMm = 0.5 * notes_.seenMm.diagonal();
    MACULA_TRY(splat::TrainingView picture, trainingView(trainer_, notes_.seenMm, std::move(view)));
    picture = reducedTo(std::move(picture), options_.learntSidePx);
    const splat::RasterView& from = picture.view;
    std::erase_if(asked_, [&](const Camera& camera) {
        const auto asked = splat::rasterView(camera, options_.wanted.sizePx, originMm);
        return asked && isSamePose(*asked, from, radiusMm, options_.wanted.admission);
    });
    if (const auto same = learntViewOf(from)) {
        if (!(picture.weight > trainer_.view(*same).weight)) return Offered::nothingNew;
        MACULA_TRY_VOID(trainer_.replaceView(*same, std::move(picture)));
        if (*same < coverage_.size()) coverage_[*same] = coverageOf(trainer_.view(*same));
        wake();
        return Offered::learnt;
    }
    if (isFull()) return Offered::full;
    if ((mayBeHeldOut || heldOut_.size() < kLeastHeldOut) && !isKnown(from)) {
        if (isHeldOut(notes_.offered, heldOut_.size(), degreesBesideHeldOut(from))) {
            picture.weight = 1.0f;
            const auto held = std::make_shared<const splat::TrainingView>(
                reducedTo(std::move(picture), options_.heldOutSidePx));
            MACULA_TRY_VOID(takeHeldOut(std::span(&held, 1)));
            ++notes_.offered;
            // Now it can be told whether more steps are worth it.
            if (pause_ == Pause::notJudged && heldOut_.size() >= kLeastHeldOut) wake();
            return Offered::heldOut;
        }
    }
    MACULA_TRY(const Novelty novelty,
               admit(trainer_, std::move(picture), radiusMm, options_.wanted.admission));
    if (novelty == Novelty::none) return Offered::nothingNew;
    if (novelty == Novelty::pose) ++notes_.offered;
    wake();
    return Offered::learnt;
}

}  // namespace macula::hybrid
