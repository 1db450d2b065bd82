#include "live/frame/picture_course.h"

#include <algorithm>

namespace macula::live {

std::string_view nameOf(OnScreen picture) {
    switch (picture) {
        case OnScreen::nothing:
            return "nothing";
        case OnScreen::preview:
            return "small, traced";
        case OnScreen::estimate:
            return "estimate";
        case OnScreen::model:
            return "model";
        case OnScreen::fading:
            return "model fading into traced";
        case OnScreen::traced:
            return "traced";
    }
    return "nothing";
}

std::string_view nameOf(Step step) {
    switch (step) {
        case Step::none:
            return "nothing";
        case Step::showModel:
            return "draw model";
        case Step::traceFovea:
            return "trace fovea";
        case Step::showPreview:
            return "small picture";
        case Step::search:
            return "search";
        case Step::trace:
            return "trace picture";
        case Step::showTraced:
            return "show traced";
        case Step::fade:
            return "fade";
        case Step::learn:
            return "learn";
        case Step::learnPhases:
            return "learn phases";
    }
    return "nothing";
}

void PictureCourse::want(bool isTraced) {
    onScreen_ = OnScreen::nothing;
    isTraced_ = isTraced;
    hasConverged_ = hasConverged_ && isTraced;
    previewSamples_ = 0;
    hasSearched_ = false;
    tracedMs_ = learntMs_ = phasesMs_ = 0.0;
}

void PictureCourse::setModel(ModelState state, bool learns) {
    model_ = state;
    learns_ = learns;
}

Step PictureCourse::next(TimePoint now) const {
    switch (onScreen_) {
        case OnScreen::nothing:
            if (!handMoves_ && isTraced_) return Step::showTraced;
            return model_ == ModelState::ready || hasEstimate_ ? Step::showModel : Step::showPreview;
        case OnScreen::preview: {
            if (model_ == ModelState::ready || hasEstimate_) return Step::showModel;
            if (isQuick_ && !handMoves_) return isLearningsTurn() ? Step::learn : Step::trace;
            // Once tracing at full size has begun, the small picture is lost.
            const bool canRefine = previewSamples_ < previewLimit_ && tracedMs_ <= 0.0;
            const bool isSettled = !handMoves_ && now - previewSince_ >= kSettle;
            if (model_ == ModelState::searching) {
                if (isSettled && !isSearchsTurn()) return Step::trace;
                const bool isWorthIt = canRefine && (handMoves_ || previewSamples_ < kRefinedWhileSearching);
                return hasSearched_ && isWorthIt ? Step::showPreview : Step::search;
            }
            const bool isYoung = learns_ && model_ == ModelState::young;
            if (isYoung && handMoves_) return hasSearched_ && canRefine ? Step::showPreview : Step::learn;
            if (isSettled) return isLearningsTurn() ? Step::learn : Step::trace;
            return canRefine ? Step::showPreview : handMoves_ ? Step::none : Step::trace;
        }
        case OnScreen::estimate:
            return nextOverEstimate();
        case OnScreen::model:
            if (!handMoves_ && isTraced_) return Step::showTraced;
            if (wantsFovea_) return Step::traceFovea;
            if (handMoves_) return learnsBesideHand_ ? Step::learn : Step::none;
            return Step::trace;
        case OnScreen::fading:
            return Step::fade;
        case OnScreen::traced: {
            // While a hand holds the picture the model does not learn: the hand will move soon.
            if (model_ == ModelState::searching && !handMoves_ && isSearchsTurn()) return Step::search;
            if (!handMoves_ && isPhasesTurn()) return Step::learnPhases;
            if (!handMoves_ && isLearningsTurn()) return Step::learn;
            return hasConverged_ ? Step::none : Step::trace;
        }
    }
    return Step::none;
}

// An estimate stays while the scene's model is searched for and trained.
Step PictureCourse::nextOverEstimate() const {
    if (!handMoves_ && isTraced_) return Step::showTraced;
    if (model_ == ModelState::ready) return Step::showModel;
    if (!hasEstimate_) return Step::showPreview;
    if (handMoves_) {
        // A slice after each frame: a hand that never rests gets its model too.
        if (hasSearched_ || !learns_) return Step::none;
        return model_ == ModelState::searching ? Step::search : Step::learn;
    }
    if (model_ == ModelState::searching && !isQuick_) return isSearchsTurn() ? Step::search : Step::trace;
    return isLearningsTurn() ? Step::learn : Step::trace;
}

// While there is no traced picture of all pixels: whether search and learning still come before it.
bool PictureCourse::isBeforeTraced() const {
    const bool isBefore = onScreen_ == OnScreen::preview || onScreen_ == OnScreen::estimate;
    return isBefore && learntMs_ < kYoungFirstMs;
}

// Whether it is the search's turn, before the full-size picture or while it is traced.
bool PictureCourse::isSearchsTurn() const {
    if (onScreen_ == OnScreen::traced && hasConverged_) return true;
    return isBeforeTraced() || learntMs_ <= kYoungShare * tracedMs_;
}

// Whether it is training's turn, at rest: before the full-size picture or while it is traced.
bool PictureCourse::isLearningsTurn() const {
    const bool isYoung = model_ == ModelState::young;
    if (!learns_ || (!isYoung && model_ != ModelState::ready)) return false;
    if (onScreen_ == OnScreen::traced && hasConverged_) return true;
    if (isYoung && !isQuick_ && isBeforeTraced()) return true;
    const double share = !isYoung ? kReadyShare : isQuick_ ? kYoungShareWhereQuick : kYoungShare;
    return learntMs_ < share * tracedMs_;
}

// The phase on screen comes first: others begin with what it has learnt.
bool PictureCourse::isPhasesTurn() const {
    if (!learnsPhases_ || (learns_ && model_ != ModelState::ready)) return false;
    const bool isIdle = hasConverged_ && !learns_;
    return isIdle || phasesMs_ < kPhasesShare * (tracedMs_ + learntMs_);
}

void PictureCourse::showedModel() {
    onScreen_ = OnScreen::model;
}

void PictureCourse::showedEstimate() {
    onScreen_ = OnScreen::estimate;
    hasSearched_ = false;
}

void PictureCourse::showedPreview(std::uint64_t samples, TimePoint now) {
    if (onScreen_ != OnScreen::preview) previewSince_ = now;
    onScreen_ = OnScreen::preview;
    previewSamples_ = samples;
    hasSearched_ = false;
    isTraced_ = hasConverged_ = false;
}

void PictureCourse::traced(bool hasConverged) {
    isTraced_ = true;
    hasConverged_ = hasConverged;
    if (onScreen_ == OnScreen::fading) return;
    if (onScreen_ != OnScreen::traced)
        tracedMs_ = learntMs_ = phasesMs_ = 0.0;  // tracing and training take turns now
    const bool fades = isOfSplats(onScreen_);
    onScreen_ = fades ? OnScreen::fading : OnScreen::traced;
    fadingSince_.reset();
}

void PictureCourse::showedTraced() {
    onScreen_ = OnScreen::traced;
}

double PictureCourse::tracedShare(TimePoint now) const {
    using Ms = std::chrono::duration<double, std::milli>;
    if (!fadingSince_) return 0.0;
    const double t = std::clamp(Ms(now - *fadingSince_) / Ms(kFade), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

void PictureCourse::faded(TimePoint now) {
    if (onScreen_ != OnScreen::fading) return;
    if (!fadingSince_) fadingSince_ = now;
    if (tracedShare(now) >= 1.0) onScreen_ = OnScreen::traced;
}

void PictureCourse::spent(Step step, double ms) {
    if (step == Step::trace) tracedMs_ += ms;
    if (step == Step::search) learntMs_ += ms;
    if (step == Step::learnPhases) phasesMs_ += ms;
    if (step != Step::learn) return;
    learntMs_ += ms;
    hasSearched_ = true;  // a small picture is next, where one is worth it
}

}  // namespace macula::live
