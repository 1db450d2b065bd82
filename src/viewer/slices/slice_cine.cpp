#include "viewer/slices/slice_cine.h"

#include <utility>

namespace macula::viewer {

namespace {

constexpr int kCineMs = 100;

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

}  // namespace macula::viewer
