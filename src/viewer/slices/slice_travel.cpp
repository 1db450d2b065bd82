#include "viewer/slices/slice_travel.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/camera.h"

namespace macula::viewer {

namespace {

constexpr int kCineMs = 100;

constexpr int kPauseMs = 600;

// The point of the plane nearest to `mm` that is not beside the volume. There are no slices beside it: other
// panes would show their last one, with a cross-hair that is elsewhere.
glm::dvec3 placeBesideNoVolume(const Volume& volume, const slices::SlicePlane& plane, const glm::dvec3& mm) {
    const auto corners = cornersOf(volume.worldBox());
    glm::dvec3 place = mm;
    for (const glm::dvec3& along : {plane.right, plane.down}) {
        double low = std::numeric_limits<double>::max();
        double high = std::numeric_limits<double>::lowest();
        for (const glm::dvec3& corner : corners) {
            low = std::min(low, glm::dot(corner, along));
            high = std::max(high, glm::dot(corner, along));
        }
        const double at = glm::dot(place, along);
        place += (std::clamp(at, low, high) - at) * along;
    }
    return place;
}

}  // namespace

SliceCine::SliceCine(StudyEditor& session, const PaneContent& content, std::function<bool()> isSeen)
    : session_(session), content_(content), isSeen_(std::move(isSeen)) {
    timer_.setInterval(kCineMs);
    connect(&timer_, &QTimer::timeout, this, &SliceCine::step);
}

void SliceCine::start() {
    if (isOn() || !content_.hasStudy()) return;
    timer_.start();
    Q_EMIT changed(true);
}

void SliceCine::stop() {
    if (!isOn()) return;
    timer_.stop();
    if (session_.undoText() == tr("Cine"))
        session_.endDrag();  // a person may be dragging something else by now
    Q_EMIT changed(false);
}

void SliceCine::step() {
    const int last = content_.steps().count() - 1;
    if (!isSeen_() || last < 1) return;
    const int now = content_.slice();
    if (now == 0) goesBack_ = false;
    if (now == last) goesBack_ = true;
    const glm::dvec3 to = content_.crosshairOn(goesBack_ ? now - 1 : now + 1);
    session_.drag(tr("Cine"), [&](scene::StudyState& next) { next.slices.crosshairMm = to; });
}

SliceTravel::SliceTravel(StudyEditor& session, const PaneContent& content, const PaneZoom& zoom)
    : session_(session), content_(content), zoom_(zoom) {
    stepsEnd_.setSingleShot(true);
    stepsEnd_.setInterval(kPauseMs);
    connect(&stepsEnd_, &QTimer::timeout, this, [this] {
        endOwnDrag(tr("Slice"));
        endOwnDrag(tr("Second volume moved"));
    });
}

void SliceTravel::moveBy(int slices) {
    if (!content_.hasStudy()) return;
    if (content_.wantsSecond() && !content_.secondState()->isLinked()) return moveSecond(slices);
    goTo(content_.slice() + (content_.steps().stepMm() > 0.0 ? slices : -slices));
}

void SliceTravel::goTo(int slice) {
    const glm::dvec3 to = content_.crosshairOn(slice);
    session_.drag(tr("Slice"), [&](scene::StudyState& next) { next.slices.crosshairMm = to; });
    stepsEnd_.start();
}

// Moves the second volume along the pane's normal, by its own slices.
void SliceTravel::moveSecond(int slices) {
    const slices::SlicePlane shown = zoom_.plane();
    const Volume& second = *content_.second()->study.measured();
    const glm::dmat4 from = content_.secondState()->secondFromStudy;
    const slices::SlicePlane there{.centreMm = transformPoint(from, shown.centreMm),
                                   .right = transformVector(from, shown.right),
                                   .down = transformVector(from, shown.down)};
    const double byMm = slices * slices::stepMm(second, there);
    const slices::DepthRange depths = slices::depthsMm(second, there);
    if (byMm > depths.highMm || byMm < depths.lowMm) return;  // the volume would leave the plane
    const glm::dvec3 by = byMm * there.normal();
    session_.drag(tr("Second volume moved"), [&](scene::StudyState& next) {
        next.secondVolume->secondFromStudy[3] += glm::dvec4(by, 0.0);
    });
    stepsEnd_.start();
}

void SliceTravel::turnWheel(int eighths, bool fast) {
    wheelRest_ += eighths;
    const int notches = wheelRest_ / kNotch;
    wheelRest_ -= notches * kNotch;
    if (notches != 0) moveBy(fast ? notches * kManySlices : notches);
}

void SliceTravel::pointAt(const glm::dvec3& mm, SliceShows shows) {
    if (shows == SliceShows::secondByHand) return;  // the point has no known position in the study
    const glm::dvec3 to =
        shows == SliceShows::study ? placeBesideNoVolume(content_.volume(), zoom_.plane(), mm) : mm;
    session_.drag(tr("Cross-hair"), [&](scene::StudyState& next) { next.slices.crosshairMm = to; });
}

// By the time the timer ends a step, a person may be dragging something else.
void SliceTravel::endOwnDrag(const QString& what) {
    if (session_.undoText() == what) session_.endDrag();
}

}  // namespace macula::viewer
