#include "viewer/slices/pane_content.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/frames.h"
#include "pipeline/volume/window.h"
#include "scene/second/second_study.h"

namespace macula::viewer {

namespace {

constexpr double kFarthest = 4.0;
constexpr double kClosest = 1.0 / 64.0;
constexpr int kMostSteps = 64;
constexpr double kInsideVoxels = 1e-3;

// A point near `from` that lies in both plane and volume, found by alternating projections (von Neumann);
// nothing if they do not meet.
std::optional<glm::dvec3> placeInVolume(const PlacedGrid& volume, const slices::SlicePlane& plane,
                                        const glm::dvec3& from) {
    const glm::dmat4 voxelFromPane = glm::inverse(volume.paneFromVoxel);
    const glm::dvec3 low(-0.5);
    const glm::dvec3 high = glm::dvec3(volume.size) - 0.5;
    const glm::dvec3 normal = plane.normal();
    glm::dvec3 mm = from;
    for (int step = 0; step < kMostSteps; ++step) {
        const glm::dvec3 voxel = transformPoint(voxelFromPane, mm);
        const glm::dvec3 inside = glm::clamp(voxel, low, high);
        if (glm::distance(voxel, inside) < kInsideVoxels) return mm;
        mm = transformPoint(volume.paneFromVoxel, inside);
        mm += normal * glm::dot(plane.centreMm - mm, normal);
    }
    return std::nullopt;
}

bool isFinite(const glm::dvec3& mm) {
    return std::isfinite(mm.x) && std::isfinite(mm.y) && std::isfinite(mm.z);
}

}  // namespace

PaneView fittedView(const Volume& volume, const SliceSteps& steps, const glm::ivec2& sizePx) {
    PaneView view{.centreMm = middleMm(volume)};
    if (sizePx.x < 1 || sizePx.y < 1) return view;
    view.mmPerPx =
        slices::fittedMmPerPixel(volume, steps.plane(steps.nearest(view.centreMm), view.centreMm), sizePx);
    return view;
}

PaneView withinReach(const PaneView& view, const slices::SlicePlane& plane,
                     std::span<const PlacedGrid> volumes) {
    const glm::dvec3 normal = plane.normal();
    const double offMm = glm::dot(view.centreMm - plane.centreMm, normal);
    const glm::dvec3 middle = view.centreMm - offMm * normal;
    std::optional<glm::dvec3> nearest;
    for (const PlacedGrid& volume : volumes) {
        const auto place = placeInVolume(volume, plane, middle);
        if (place && (!nearest || glm::distance(*place, middle) < glm::distance(*nearest, middle)))
            nearest = place;
    }
    PaneView within = view;
    if (nearest) within.centreMm = *nearest + offMm * normal;
    return within;
}

PaneView panned(const PaneView& view, const slices::SlicePlane& plane, const glm::dvec2& byPx) {
    PaneView moved = view;
    moved.centreMm -= (plane.right * byPx.x + plane.down * byPx.y) * view.mmPerPx;
    return moved;
}

PaneView zoomed(const PaneView& view, const slices::SlicePlane& plane, const glm::dvec2& fromMiddlePx,
                double factor, double fittedMmPerPx) {
    if (!(factor > 0.0) || !std::isfinite(factor)) return view;
    PaneView closer = view;
    closer.mmPerPx = std::clamp(view.mmPerPx / factor, fittedMmPerPx * kClosest, fittedMmPerPx * kFarthest);
    closer.centreMm +=
        (plane.right * fromMiddlePx.x + plane.down * fromMiddlePx.y) * (view.mmPerPx - closer.mmPerPx);
    return closer;
}

slices::SliceFrame frameOf(const PaneView& view, const SliceSteps& steps, int slice, const glm::ivec2& sizePx,
                           double pixelRatio) {
    return {.plane = steps.plane(slice, view.centreMm),
            .mmPerPixel = view.mmPerPx / pixelRatio,
            .sizePx = glm::ivec2(glm::round(glm::dvec2(sizePx) * pixelRatio))};
}

PaneContent::PaneContent(const StudyEditor& session, slices::Orientation orientation, PaneRole role)
    : session_(session), orientation_(orientation), role_(role) {}

void PaneContent::clear() {
    steps_.reset();
    setPhase(nullptr, {});
}

void PaneContent::setPhase(std::shared_ptr<const study::OpenedStudy> phase, const QString& text,
                           std::optional<DisplayWindow> ofDifference) {
    phase_ = std::move(phase);
    phaseText_ = text;
    ofDifference_ = std::move(ofDifference);
}

void PaneContent::takeStudy() {
    usualWindow_ = seriesWindow(volume());
    turnPlanes();
}

void PaneContent::turnPlanes() {
    std::optional<PlaneTurn> turn;
    if (state().slices.turn) turn = PlaneTurn{.turn = *state().slices.turn, .aboutMm = crosshairMm()};
    steps_.emplace(volume(), orientation_, state().slices.asAcquired, turn);
}

bool PaneContent::wantsTurn(const scene::SliceState& before) const {
    const scene::SliceState& now = state().slices;
    return now.asAcquired != before.asAcquired || now.turn != before.turn ||
           (now.turn && now.crosshairMm != before.crosshairMm);
}

glm::dvec3 PaneContent::normalOf(slices::Orientation orientation) const {
    const glm::dvec3 before = planeBeforeTurn(volume(), orientation, state().slices.asAcquired).normal();
    return state().slices.turn ? *state().slices.turn * before : before;
}

glm::dvec3 PaneContent::crosshairMm() const {
    const auto& set = state().slices.crosshairMm;
    return set && isFinite(*set) ? *set : middleMm(volume());
}

glm::dvec3 PaneContent::crosshairOn(int slice) const {
    return steps_->onSlice(std::clamp(slice, 0, steps_->count() - 1), crosshairMm());
}

DisplayWindow PaneContent::studyWindow() const {
    return showsDifference() ? *ofDifference_ : valueWindow();
}

DisplayWindow PaneContent::valueWindow() const {
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
    if (secondState()->linksWindow) return valueWindow();
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
