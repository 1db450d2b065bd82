#include "viewer/curve/curve_controller.h"

#include <QMainWindow>

#include "segment/vessel_path.h"
#include "viewer/curve/curve_panel.h"
#include "viewer/editor/study_editor.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

CurveController::CurveController(const WindowContext& context)
    : QObject(&context.window),
      context_(context),
      panel_(new CurvePanel(context.session, &context.window)),
      following_(this, {.ended = [this](const Result<std::vector<glm::dvec3>>& wayMm) { use(wayMm); }}) {
    connect(panel_, &CurvePanel::followAsked, this, &CurveController::follow);
    // The way through other points is another one.
    const auto stop = [this] {
        if (following_.cancel()) panel_->setFollowing(false);
    };
    connect(&context_.session, &StudyEditor::studyShown, this, stop);
    connect(&context_.session, &StudyEditor::changed, this, [this, stop](const scene::StudyState& before) {
        if (before.slices.curveMm != context_.session.state().slices.curveMm) stop();
    });
}

void CurveController::follow() {
    panel_->setFollowing(true);
    following_.start([volume = panel_->study().measured(),
                      points = context_.session.state().slices.curveMm](Progress& progress) {
        return segment::vesselPath(*volume, points, progress.token());
    });
}

void CurveController::use(const Result<std::vector<glm::dvec3>>& wayMm) {
    panel_->setFollowing(false);
    if (!wayMm) {
        if (wayMm.error().code != ErrorCode::cancelled) context_.notifications.showError(wayMm.error());
        return;
    }
    context_.session.change(tr("Follow the Vessel"),
                            [&](scene::StudyState& next) { next.slices.curveMm = *wayMm; });
}

}  // namespace macula::viewer
