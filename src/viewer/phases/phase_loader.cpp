#include "viewer/phases/phase_loader.h"

#include <utility>

namespace macula::viewer {

namespace {

// Together with the open study, its pool on the device and its model this stays below a usual machine.
constexpr std::size_t kMostBytes = std::size_t{4} << 30;

std::size_t bytesOf(const study::OpenedStudy& study) {
    const glm::ivec3 size = study.volume->size();
    const auto voxels = std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    return voxels * (study.inFloats ? 6 : 2);
}

Error noRoom() {
    return {ErrorCode::outOfMemory,
            Text("Memory is not enough for all phases at once."),
            {},
            Text("Open each phase by itself.")};
}

std::size_t apart(std::size_t a, std::size_t b) {
    return a < b ? b - a : a - b;
}

}  // namespace

PhaseLoader::PhaseLoader(QObject* parent)
    : QObject(parent),
      job_(this, {.ended = [this](const Result<study::OpenedStudy>& study) { take(study); }}) {}

void PhaseLoader::setPhases(study::PhaseSource source, std::vector<std::size_t> volumes) {
    if (source == source_ && volumes == volumes_) return;
    job_.cancel();
    loading_.reset();
    loaded_.clear();
    failed_.clear();
    fits_ = true;
    source_ = std::move(source);
    volumes_ = std::move(volumes);
}

void PhaseLoader::keepOpen(std::size_t phase, std::shared_ptr<const study::OpenedStudy> study) {
    open_ = phase;
    if (phase < volumes_.size()) loaded_[phase] = std::move(study);
}

void PhaseLoader::ask(std::size_t phase) {
    asked_ = phase;
    if (const auto failure = failed_.find(phase); failure != failed_.end())
        return Q_EMIT failed(phase, failure->second);
    startNext();
}

std::optional<Error> PhaseLoader::whyNotAll() const {
    if (!failed_.empty()) return failed_.begin()->second;
    if (!fits_) return noRoom();
    return std::nullopt;
}

std::shared_ptr<const study::OpenedStudy> PhaseLoader::phase(std::size_t phase) const {
    const auto found = loaded_.find(phase);
    return found == loaded_.end() ? nullptr : found->second;
}

std::optional<std::size_t> PhaseLoader::next() const {
    std::optional<std::size_t> nearest;
    for (std::size_t phase = 0; phase < volumes_.size(); ++phase) {
        if (loaded_.contains(phase) || failed_.contains(phase)) continue;
        if (!nearest || apart(phase, asked_) < apart(*nearest, asked_)) nearest = phase;
    }
    return nearest;
}

// All phases have one grid, so they are as large as those that are there. Drops the one that is farthest from
// what is asked for; false if there is none to drop.
bool PhaseLoader::makeRoom() {
    const std::size_t bytes = loaded_.empty() ? 0 : bytesOf(*loaded_.begin()->second);
    if (bytes * (loaded_.size() + 1) <= kMostBytes) return true;
    fits_ = false;
    auto farthest = loaded_.end();
    for (auto kept = loaded_.begin(); kept != loaded_.end(); ++kept) {
        if (kept->first == open_) continue;
        if (farthest == loaded_.end() || apart(kept->first, asked_) > apart(farthest->first, asked_))
            farthest = kept;
    }
    if (farthest == loaded_.end()) return false;
    loaded_.erase(farthest);
    return true;
}

void PhaseLoader::startNext() {
    if (job_.running()) return;
    const std::optional<std::size_t> phase = next();
    if (!phase || (!fits_ && *phase != asked_)) return;
    const bool isAsked = *phase == asked_;
    const std::size_t bytes = loaded_.empty() ? 0 : bytesOf(*loaded_.begin()->second);
    if (!isAsked && bytes * (loaded_.size() + 1) > kMostBytes) {
        fits_ = false;
        return;
    }
    if (!makeRoom()) return Q_EMIT failed(*phase, noRoom());
    loading_ = phase;
    job_.start([source = source_, volume = volumes_[*phase]](Progress& progress) {
        return study::openPhase(source, volume, progress);
    });
}

void PhaseLoader::take(const Result<study::OpenedStudy>& study) {
    if (!loading_) return;
    const std::size_t phase = *std::exchange(loading_, std::nullopt);
    if (study) {
        loaded_[phase] = std::make_shared<const study::OpenedStudy>(*study);
        Q_EMIT loaded(phase);
    } else if (study.error().code != ErrorCode::cancelled) {
        failed_.emplace(phase, study.error());
        Q_EMIT failed(phase, study.error());
    }
    startNext();
}

}  // namespace macula::viewer
