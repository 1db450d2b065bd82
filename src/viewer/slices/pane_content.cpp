#include "viewer/slices/pane_content.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/volume/window.h"
#include "scene/second/second_study.h"

namespace macula::viewer {

namespace {

bool isFinite(const glm::dvec3& mm) {
    return std::isfinite(mm.x) && std::isfinite(mm.y) && std::isfinite(mm.z);
}

}  // namespace

PaneContent::PaneContent(const StudyEditor& session, slices::Orientation orientation, PaneRole role)
    : session_(session), orientation_(orientation), role_(role) {}

void PaneContent::takeStudy() {
    usualWindow_ = seriesWindow(volume());
    turnPlanes();
}

void PaneContent::turnPlanes() {
    steps_.emplace(volume(), orientation_, state().slices.asAcquired);
}

glm::dvec3 PaneContent::crosshairMm() const {
    const auto& set = state().slices.crosshairMm;
    return set && isFinite(*set) ? *set : middleMm(volume());
}

glm::dvec3 PaneContent::crosshairOn(int slice) const {
    return steps_->onSlice(std::clamp(slice, 0, steps_->count() - 1), crosshairMm());
}

DisplayWindow PaneContent::studyWindow() const {
    const auto& set = state().slices.window;
    return set ? *set : usualWindow_;
}

void PaneContent::setSecond(std::shared_ptr<const SecondVolumeTexts> second) {
    second_ = std::move(second);
}

const scene::SecondVolumeState* PaneContent::secondState() const {
    const auto& now = state().secondVolume;
    return second_ && now && scene::isPlacedFor(*now, second_->study, second_->pair) ? &*now : nullptr;
}

DisplayWindow PaneContent::secondWindow() const {
    if (secondState()->linksWindow) return studyWindow();
    return secondState()->window.value_or(second_->usualWindow);
}

bool PaneContent::wantsSecond() const {
    const scene::SecondVolumeState* now = secondState();
    if (now == nullptr) return false;
    return role_ == PaneRole::second || now->view == scene::SecondVolumePlace::instead;
}

const Volume& PaneContent::wantedVolume() const {
    return wantsSecond() ? *second_->study.measured() : volume();
}

DisplayWindow PaneContent::wantedWindow() const {
    return wantsSecond() ? secondWindow() : studyWindow();
}

// The second volume may extend beyond the study.
std::vector<PlacedGrid> PaneContent::placedVolumes() const {
    std::vector<PlacedGrid> placed{{volume().worldFromVoxel(), volume().size()}};
    if (const scene::SecondVolumeState* now = secondState())
        placed.push_back({glm::inverse(now->secondFromStudy) * second_->study.volume->worldFromVoxel(),
                          second_->study.volume->size()});
    return placed;
}

}  // namespace macula::viewer
