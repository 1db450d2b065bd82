#include "viewer/phases/phase_loader.h"

#include <algorithm>
#include <utility>

#include "study/open/found_volumes.h"

namespace macula::viewer {

namespace {

// Together with the open study, its pool on the device and its model this stays below a usual machine.
constexpr std::size_t kMostBytes = std::size_t{4} << 30;

std::size_t bytesOf(const study::OpenedStudy& study) {
    const glm::ivec3 size = study.volume->size();
    const auto voxels = std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    return voxels * (study.inFloats ? 6 : 2);
}

std::size_t apart(std::size_t a, std::size_t b) {
    return a < b ? b - a : a - b;
}

}  // namespace

PhaseLoader::PhaseLoader(QObject* parent)
    : QObject(parent), job_(this, {.ended = [this](const Result<study::OpenedStudy>& study) { take(study); }}) {}

void PhaseLoader::setPhases(std::shared_ptr<const study::FoundVolumes> found,
                            std::vector<std::size_t> volumes) {
    if (found == found_ && volumes == volumes_) return;
    job_.cancel();
    loading_.reset();
    loaded_.clear();
    failed_.clear();
    fits_ = true;
    found_ = std::move(found);
    volumes_ = std::move(volumes);
}

void PhaseLoader::keep(std::size_t phase, std::shared_ptr<const study::OpenedStudy> study) {
    if (phase < volumes_.size()) loaded_[phase] = std::move(study);
}

void PhaseLoader::ask(std::size_t phase) {
    asked_ = phase;
    startNext();
}

std::shared_ptr<const study::OpenedStudy> PhaseLoader::phase(std::size_t phase) const {
    const auto found = loaded_.find(phase);
    return found == loaded_.end() ? nullptr : found->second;
}

// All phases have one grid, so they are as large as those that are there.
std::optional<std::size_t> PhaseLoader::next() const {
    std::optional<std::size_t> nearest;
    for (std::size_t phase = 0; phase < volumes_.size(); ++phase) {
        if (loaded_.contains(phase) || std::ranges::find(failed_, phase) != failed_.end()) continue;
        if (!nearest || apart(phase, asked_) < apart(*nearest, asked_)) nearest = phase;
    }
    return nearest;
}

void PhaseLoader::startNext() {
    if (job_.running()) return;
    const std::optional<std::size_t> phase = next();
    if (!phase) return;
    const std::size_t bytes = loaded_.empty() ? 0 : bytesOf(*loaded_.begin()->second);
    if (bytes * (loaded_.size() + 1) > kMostBytes) {
        fits_ = false;
        if (*phase != asked_ || loaded_.size() < 2) return;
        // The farthest one makes room; not that of the open study, which is held elsewhere anyway.
        const auto farthest = std::ranges::max_element(
            loaded_, {}, [this](const auto& kept) { return apart(kept.first, asked_); });
        loaded_.erase(farthest);
    }
    loading_ = phase;
    job_.start([found = found_, volume = volumes_[*phase]](Progress& progress) {
        return study::openFoundVolume(found, volume, progress);
    });
}

void PhaseLoader::take(const Result<study::OpenedStudy>& study) {
    if (!loading_) return;
    const std::size_t phase = *std::exchange(loading_, std::nullopt);
    if (study) {
        loaded_[phase] = std::make_shared<const study::OpenedStudy>(*study);
        Q_EMIT loaded(phase);
    } else if (study.error().code != ErrorCode::cancelled) {
        failed_.push_back(phase);
        Q_EMIT failed(phase, study.error());
    }
    startNext();
}

}  // namespace macula::viewer
