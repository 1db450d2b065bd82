// What a pane does with a second volume, in the place of the study or over it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/volume/window.h"
#include "scene/second/second_study.h"
#include "slices/interpolated.h"
#include "viewer/overlay/slice_texts.h"
#include "viewer/slices/slice_view.h"

namespace macula::viewer {

namespace {

// The slice of another volume that a plane of the study lies in; nothing where they are not parallel.
std::optional<int> sliceIn(const Volume& volume, const slices::SlicePlane& plane,
                           const glm::dmat4& volumeFromStudy) {
    constexpr double kSameDirection = 1e-4;  // as of SliceSteps
    const glm::dmat4 voxelFromStudy = glm::inverse(volume.worldFromVoxel()) * volumeFromStudy;
    const glm::dvec3 gradient{voxelFromStudy[0][2], voxelFromStudy[1][2], voxelFromStudy[2][2]};
    if (glm::length(glm::cross(glm::normalize(gradient), plane.normal())) > kSameDirection) return {};
    const double at = std::round(transformPoint(voxelFromStudy, plane.centreMm).z);
    return at >= 0.0 && at < volume.size().z ? std::optional(int(at)) : std::nullopt;
}

}  // namespace

void SliceView::setSecond(std::shared_ptr<const SecondVolumeTexts> second) {
    second_ = std::move(second);
    if (!second_ && (role_ == PaneRole::second || !isVisible())) {
        ++study_;
        wanted_.reset();
        shown_.reset();
        SliceRequest nothing;  // it keeps no volume that is gone
        nothing.study = study_;
        sampler_->publish(std::move(nothing));
    }
    request();
    update();
}

void SliceView::setPaneView(const PaneView& view) {
    if (view == view_) return;
    view_ = view;
    told_ = view;
    isFitted_ = false;
    request();
}

void SliceView::showArea(const scene::SliceArea& area) {
    if (!steps_ || area.orientation != orientation_ || width() < 1 || height() < 1) return;
    const glm::dvec2 mmPerPx = area.sizeMm / glm::dvec2(width(), height());
    const double coarser = std::max(mmPerPx.x, mmPerPx.y);
    if (!(coarser > 0.0) || !std::isfinite(coarser)) return;
    setPaneView(withinReach({.centreMm = area.centreMm, .mmPerPx = coarser}, plane(), placedVolumes()));
}

// The second one too: it may reach farther than the study.
std::vector<PlacedGrid> SliceView::placedVolumes() const {
    std::vector<PlacedGrid> placed{{volume().worldFromVoxel(), volume().size()}};
    if (const scene::SecondVolumeState* state = secondVolume())
        placed.push_back({glm::inverse(state->secondFromStudy) * second_->study.volume->worldFromVoxel(),
                          second_->study.volume->size()});
    return placed;
}

// Null unless the second volume that is there is the one of the state.
const scene::SecondVolumeState* SliceView::secondVolume() const {
    const auto& state = session_.state().secondVolume;
    return second_ && state && scene::isPlacedFor(*state, second_->study, second_->pair) ? &*state : nullptr;
}

bool SliceView::wantsSecond() const {
    const scene::SecondVolumeState* state = secondVolume();
    if (state == nullptr) return false;
    return role_ == PaneRole::second || state->view == scene::SecondVolumePlace::instead;
}

const Volume& SliceView::wantedVolume() const {
    return wantsSecond() ? *second_->study.measured() : volume();
}

DisplayWindow SliceView::secondWindow() const {
    if (secondVolume()->linksWindow) return studyWindow();
    return secondVolume()->window.value_or(second_->usualWindow);
}

bool SliceView::secondIsInverted() const {
    return session_.state().slices.isInverted != second_->study.isLowBright;
}

// Completes what is wanted for, which is of the study so far.
void SliceView::addSecond(SliceRequest& request) const {
    const scene::SecondVolumeState* state = secondVolume();
    if (state == nullptr) return;
    const bool isCalibrated = second_->study.measured()->provenance().isCalibrated;
    request.tags = {second_->studyTag};
    if (wantsSecond()) {
        request.volume = second_->study.measured();
        request.volumeFromPane = state->secondFromStudy;
        request.shows = state->isLinked() ? SliceShows::second : SliceShows::secondByHand;
        request.window = secondWindow();
        request.isInverted = secondIsInverted();
        request.isLowBright = second_->study.isLowBright;
        request.segments.reset();  // they are of the study's voxels
        request.positionText = secondPositionText(*state, request);
        request.tags = {second_->tag};
        request.names = second_->lines;
        request.secondNotes = {linkText(*state)};
        if (!request.volume->provenance().interpolatedSlices.empty())
            request.secondNotes.push_back(tr("Some of its slices are interpolated"));
        if (!isCalibrated) request.secondNotes.push_back(tr("The size of its pixels is not calibrated"));
    } else if (role_ == PaneRole::study && state->view == scene::SecondVolumePlace::over &&
               state->isLinked()) {
        request.over =
            SliceOver{.volume = second_->study.measured(),
                      .volumeFromPane = state->secondFromStudy,
                      .window = secondWindow(),
                      // Colours are no custom of films.
                      .isInverted = second_->study.isLowBright && !isActivity(*second_->study.volume),
                      .colours = state->colours,
                      .opacity = state->opacity};
        request.tags.push_back(tr("In colours: %1").arg(second_->tag));
        request.secondNotes = {linkText(*state)};
        if (!second_->study.measured()->provenance().interpolatedSlices.empty())
            request.secondNotes.push_back(tr("In colours: some slices are interpolated"));
        if (!isCalibrated)
            request.secondNotes.push_back(tr("In colours: the size of pixels is not calibrated"));
    } else {
        return;
    }
    if (!second_->patientNote.isEmpty()) request.secondNotes.prepend(second_->patientNote);
}

// With the numbers of its own slice where the pane is one of these: those of the study are of other images.
QString SliceView::secondPositionText(const scene::SecondVolumeState& state, SliceRequest& request) const {
    request.isInterpolated = false;
    if (!state.isLinked()) return tr("Not in a plane of the study");
    QString text = planeText(orientation_, *steps_, slice());
    const std::optional<int> own = sliceIn(*request.volume, request.frame.plane, state.secondFromStudy);
    if (own) {
        text = withNumbers(text, *own, request.volume->size().z, imageNumber(second_->study, *own));
        request.isInterpolated = slices::isInterpolated(*request.volume, *own);
    }
    return tr("In the plane of the study: %1").arg(text);
}

void SliceView::proposeWindow(const std::optional<DisplayWindow>& window, bool isDrag) {
    const bool ofSecond = wantsSecond();
    const auto edit = [&](scene::StudyState& next) {
        const bool isOwn = ofSecond && !next.secondVolume->linksWindow;
        (isOwn ? next.secondVolume->window : next.slices.window) = window;
    };
    const QString what = ofSecond ? tr("Window of the second volume") : tr("Window");
    if (isDrag) {
        session_.drag(what, edit);
    } else {
        session_.change(what, edit);
    }
}

// Along the normal of the pane: a slice of another volume for the one that the study shows.
void SliceView::moveSecond(int slices) {
    const slices::SlicePlane shown = plane();
    const glm::dmat4 from = secondVolume()->secondFromStudy;
    const slices::SlicePlane there{.centreMm = transformPoint(from, shown.centreMm),
                                   .right = transformVector(from, shown.right),
                                   .down = transformVector(from, shown.down)};
    const double byMm = slices * slices::stepMm(*second_->study.measured(), there);
    const slices::DepthRange depths = slices::depthsMm(*second_->study.measured(), there);
    if (byMm > depths.highMm || byMm < depths.lowMm) return;  // nothing of it would be seen
    const glm::dvec3 by = byMm * there.normal();
    session_.drag(tr("Second volume moved"), [&](scene::StudyState& next) {
        next.secondVolume->secondFromStudy[3] += glm::dvec4(by, 0.0);
    });
    wheelEnds_.start();
}

// Of what is on screen. Empty where nothing lies over it.
QString SliceView::overProbedText() const {
    if (!shown_ || !hoverAt_ || !shown_->of.over) return {};
    const SliceOver& over = *shown_->of.over;
    const glm::dvec3 mm = transformPoint(over.volumeFromPane, worldAt(*hoverAt_));
    return tr("In colours: %1").arg(probeText(*over.volume, mm));
}

QStringList SliceView::tags() const {
    return shown_ ? shown_->of.tags : QStringList();
}

bool SliceView::isMeasuring() const {
    return tool_ == SliceTool::distance || tool_ == SliceTool::angle || tool_ == SliceTool::ellipse;
}

}  // namespace macula::viewer
