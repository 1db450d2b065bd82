// The views of a peripheral model: those that it asks for, and those that it is offered.
#include <span>
#include <utility>

#include "pipeline/hybrid/model/peripheral_model.h"
#include "pipeline/hybrid/views/candidate_poses.h"
#include "pipeline/hybrid/views/held_out.h"
#include "pipeline/hybrid/views/training_views.h"

namespace macula::hybrid {

std::vector<KnownPose> PeripheralModel::knownViews() const {
    std::vector<KnownPose> known;
    while (coverage_.size() < trainer_.viewCount())
        coverage_.push_back(judgedCoverage(trainer_.view(coverage_.size())));
    for (std::size_t i = 0; i < trainer_.viewCount(); ++i) {
        if (trainer_.view(i).kind != splat::ViewKind::picture) continue;  // it has no traced picture
        known.push_back({.view = trainer_.view(i).view, .error = trainer_.lastDifference(i) / coverage_[i]});
    }
    for (const HeldOutPicture& h : heldOut_)
        known.push_back({.view = h.picture->view, .error = h.errors.trained});
    for (const splat::RasterView& view : asked_.views(trainer_.lastGood().splats.originMm))
        known.push_back({.view = view});
    return known;
}

Result<std::optional<CandidatePose>> PeripheralModel::wantedView() {
    using Wanted = std::optional<CandidatePose>;
    if (isFull()) return Wanted();
    const std::uint64_t seed = (std::uint64_t(options_.seed) << 32) + notes_.asked;
    MACULA_TRY(const std::vector<CandidatePose> wanted,
               candidatePoses(knownViews(), notes_.seenMm, trainer_.lastGood().splats.originMm, seed,
                              options_.wanted));
    MACULA_TRY(const splat::Splats now, trainer_.snapshot());
    MACULA_TRY(const Wanted chosen, firstThatShows(device_, now, wanted, options_.wanted.sizePx));
    ++notes_.asked;  // without a pose, other candidates are drawn the next time
    if (!chosen) return Wanted();
    asked_.add(chosen->camera);
    return chosen;
}

bool PeripheralModel::isFull() const {
    if (trainer_.viewCount() + heldOut_.size() >= options_.mostViews) return true;
    const double bytes = bytesOfViews(trainer_);
    return bytes > options_.viewsShare * (bytes + double(device_->memoryAvailableBytes()));
}

bool PeripheralModel::isKnown(const splat::RasterView& view) const {
    const double radiusMm = 0.5 * notes_.seenMm.diagonal();
    return hasPictureFrom(trainer_, view, radiusMm, options_.wanted.admission) ||
           heldOut_.hasFrom(view, radiusMm, options_.wanted.admission);
}

Result<void> PeripheralModel::takeHeldOut(
    std::span<const std::shared_ptr<const splat::TrainingView>> pictures) {
    MACULA_TRY_VOID(heldOut_.take(pictures, trainer_, device_, notes_.first, {*shown_, *best_}));
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
    asked_.came(from, originMm, radiusMm, options_.wanted.admission);
    if (const auto same = pictureOf(trainer_, from)) {
        if (!(picture.weight > trainer_.view(*same).weight)) return Offered::nothingNew;
        MACULA_TRY_VOID(trainer_.replaceView(*same, std::move(picture)));
        if (*same < coverage_.size()) coverage_[*same] = judgedCoverage(trainer_.view(*same));
        wake();
        return Offered::learnt;
    }
    if (isFull()) return Offered::full;
    if ((mayBeHeldOut || !heldOut_.canJudge()) && !isKnown(from)) {
        if (isHeldOut(notes_.offered, heldOut_.size(),
                      heldOut_.degreesBeside(from, notes_.seenMm.centre() - originMm))) {
            picture.weight = 1.0f;
            const auto held = std::make_shared<const splat::TrainingView>(
                reducedTo(std::move(picture), options_.heldOutSidePx));
            MACULA_TRY_VOID(takeHeldOut(std::span(&held, 1)));
            ++notes_.offered;
            // Now held-out errors can show whether more steps help.
            if (pause_ == Pause::notJudged && heldOut_.canJudge()) wake();
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
