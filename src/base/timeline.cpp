#include "base/timeline.h"

#include <algorithm>
#include <utility>

#include "base/elapsed.h"

namespace macula {

namespace {

thread_local Timeline* watching = nullptr;

template <typename Stages>
auto find(Stages& stages, std::string_view name) {
    return std::find_if(stages.begin(), stages.end(), [&](const StageTimes& s) { return s.name == name; });
}

}  // namespace

std::vector<StageTimes> since(const std::vector<StageTimes>& before, std::vector<StageTimes> now) {
    for (StageTimes& stage : now) {
        const auto old = find(before, stage.name);
        if (old == before.end()) continue;
        stage.times -= old->times;
        stage.ms -= old->ms;
        stage.waitedMs -= old->waitedMs;
    }
    std::erase_if(now, [](const StageTimes& stage) { return stage.times == 0; });
    return now;
}

Timeline::Watch::Watch(Timeline& timeline) : outer_(std::exchange(watching, &timeline)) {}

Timeline::Watch::~Watch() {
    watching = outer_;
}

TimelineStage::TimelineStage(std::string_view name) : timeline_(watching), name_(name) {
    if (timeline_ == nullptr) return;
    outer_ = std::exchange(timeline_->innermost_, this);
    start_ = Clock::now();
}

TimelineStage::~TimelineStage() {
    if (timeline_ == nullptr) return;
    const double wholeMs = msSince(start_);
    timeline_->innermost_ = outer_;
    if (outer_ != nullptr) outer_->innerMs_ += wholeMs;
    std::vector<StageTimes>& stages = timeline_->stages_;
    auto stage = find(stages, name_);
    if (stage == stages.end()) stage = stages.insert(stages.end(), StageTimes{.name = name_});
    const double ownMs = wholeMs - innerMs_;
    ++stage->times;
    stage->ms += ownMs;
    stage->waitedMs += waitedMs_;
    stage->longestMs = std::max(stage->longestMs, ownMs);
}

TimelineWait::TimelineWait() : stage_(watching != nullptr ? watching->innermost_ : nullptr) {
    if (stage_ != nullptr) start_ = std::chrono::steady_clock::now();
}

TimelineWait::~TimelineWait() {
    if (stage_ != nullptr) stage_->waitedMs_ += msSince(start_);
}

}  // namespace macula
