#include "xr/governor.h"

#include <algorithm>
#include <cmath>

namespace macula::xr {

namespace {

constexpr double kLeastPeriodMs = 1.0;
constexpr double kMostPeriodMs = 1000.0;
// A longer time is not drawing: the computer slept, or a shader was compiled.
constexpr double kMostPeriodsOfFrame = 4.0;
// Steps down at the second late frame within about kForgetsLate frames, since a single one says little.
constexpr int kLateFrames = 2;
constexpr int kForgetsLate = 8;
constexpr double kMostSavedPeriods = 2.0;
constexpr double kForgetsOverrun = 0.5;          // factor per piece of work
constexpr double kForgetsOverrunOfFrame = 0.98;  // factor per frame, if latePeriods_ is not negative

bool isTime(double ms) {
    return std::isfinite(ms) && ms >= 0.0;
}

}  // namespace

double Governor::predictedMs(double drawnMs, std::size_t level) const {
    const double ratio = kLevels[level].scale / quality().scale;
    return drawnMs * ratio * ratio;
}

void Governor::change(std::size_t level) {
    const bool isBetter = level < level_;
    (isBetter ? stepsUp_ : stepsDown_) += isBetter ? level_ - level : level - level_;
    if (!isBetter && sinceStepUp_ >= 0) patience_[level_] = std::min(2 * patience_[level_], kMostPatience);
    sinceStepUp_ = isBetter ? 0 : -1;
    level_ = level;
    late_ = 0;
    withRoom_ = 0;
}

void Governor::notePeriod(double periodMs) {
    ++frames_;
    if (isTime(periodMs) && periodMs > 0.0) periodMs_ = std::clamp(periodMs, kLeastPeriodMs, kMostPeriodMs);
}

void Governor::noteFrame(double drawnMs) {
    if (!isTime(drawnMs) || !(periodMs_ > 0.0)) return;
    latePeriods_ = std::min(latePeriods_ + kLateShare, kMostSavedPeriods);
    if (latePeriods_ >= 0.0)
        for (Habit& habit : habits_) habit.overrunMs *= kForgetsOverrunOfFrame;
    drawnMs = std::min(drawnMs, kMostPeriodsOfFrame * periodMs_);
    if (sinceStepUp_ >= 0 && ++sinceStepUp_ > 2 * kFramesWithRoom) {  // the step up has lasted
        sinceStepUp_ = -1;
        patience_[level_] = 1;
    }
    if (drawnMs > kOurShare * periodMs_) {
        withRoom_ = 0;
        late_ += kForgetsLate;
        if (late_ <= (kLateFrames - 1) * kForgetsLate || level_ + 1 == kLevels.size()) return;
        // One level down, or as many as the prediction needs to fit the period.
        std::size_t level = level_ + 1;
        while (level + 1 < kLevels.size() && predictedMs(drawnMs, level) > periodMs_) ++level;
        change(level);
        return;
    }
    late_ = std::max(late_ - 1, 0);
    if (level_ == 0 || predictedMs(drawnMs, level_ - 1) > kRoomShare * periodMs_) {
        withRoom_ = 0;
        return;
    }
    if (++withRoom_ >= patience_[level_ - 1] * kFramesWithRoom) change(level_ - 1);
}

std::optional<double> Governor::timeFor(Work work, double usedMs) {
    if (!(periodMs_ > 0.0) || !isTime(usedMs)) return std::nullopt;
    if (work == Work::fovea && frames_ % std::uint64_t(quality().framesPerFovea) != 0) return std::nullopt;
    usedMs_ = usedMs;
    const double overrunMs = habits_[std::size_t(work)].overrunMs;
    const double leftMs = kOurShare * periodMs_ - usedMs;
    if (leftMs - overrunMs >= kLeastWorkMs) return leftMs - overrunMs;
    // The work does not fit: it may make a frame late now and then, if enough late time has been saved.
    const double late = (usedMs + overrunMs) / periodMs_ - kOurShare;
    if (latePeriods_ < std::min(std::max(late, kLateShare), kMostSavedPeriods)) return std::nullopt;
    return kLeastWorkMs;
}

void Governor::noteWork(Work work, double toldMs, double tookMs) {
    if (!isTime(toldMs) || !isTime(tookMs) || !(periodMs_ > 0.0)) return;
    tookMs = std::min(tookMs, kMostPeriodsOfFrame * periodMs_);
    double& overrunMs = habits_[std::size_t(work)].overrunMs;
    overrunMs = std::max(tookMs - toldMs, kForgetsOverrun * overrunMs);
    const double end = usedMs_ + tookMs;
    if (end > periodMs_) latePeriods_ -= std::ceil(end / periodMs_) - 1.0;
}

}  // namespace macula::xr
