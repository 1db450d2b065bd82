#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/pick/pick_controller.h"

#include <QMainWindow>
#include <QMenu>

#include "scene/drawing/first_matter.h"
#include "viewer/clip/scissor_tool.h"
#include "viewer/editor/study_editor.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/pick/distance_in_3d.h"
#include "viewer/status/notifications.h"
#include "viewer/volume/shown_volume.h"

namespace macula::viewer {

PickController::PickController(const WindowContext& context, const ScissorTool& scissors)
    : QObject(&context.window),
      context_(context),
      distance_(new DistanceIn3d(context.session, this)),
      pick_(this, {.ended = [this](const Result<std::optional<glm::dvec3>>& outcome) {
                if (outcome && *outcome) show(**outcome);
            }}) {
    connect(&context_.viewport, &Viewport::doubleClicked, this, [this, &scissors](QPointF place) {
        if (context_.session.study().volume && !scissors.isOut()) start({place.x(), place.y()});
    });
    connect(distance_, &DistanceIn3d::drawn, &context_.viewport, &Viewport::updateToolMarks);
}

void PickController::addAction(QMenu& edit) {
    QAction* action = edit.addAction(tr("Measure a &Distance in 3D"));
    describe(*action, "distance-in-3d",
             tr("Double-click two places of what is seen in 3D: the straight line between them, in mm"));
    action->setCheckable(true);
    connect(action, &QAction::toggled, distance_, &DistanceIn3d::setOut);
    connect(action, &QAction::toggled, this, [this](bool on) {
        if (on) context_.notifications.showNote(tr("Double-click both ends of the distance in 3D."));
    });
}

void PickController::start(const glm::dvec2& place) {
    pick_.start([volume = context_.viewport.volume(), drawing = context_.viewport.drawing(),
                 camera = toCamera(context_.viewport.camera()), place,
                 aspect = context_.viewport.aspect()](Progress&) -> Result<std::optional<glm::dvec3>> {
        return scene::firstMatterMm(*volume, drawing, camera, place, aspect);
    });
}

void PickController::show(const glm::dvec3& mm) {
    if (distance_->isOut()) return measureTo(mm);
    context_.viewport.centreOn(mm);
    context_.session.change(tr("Cross-hair"), [&](scene::StudyState& next) { next.slices.crosshairMm = mm; });
}

void PickController::measureTo(const glm::dvec3& mm) {
    const auto made = distance_->add(mm);
    if (!made)
        return context_.notifications.showNote(
            tr("Turn the picture as you like, and double-click the other end."));
    const std::string text = slices::textOf(*made, *context_.session.study().measured());
    context_.notifications.showNote(
        tr("%1 in a straight line. It is in the list of measurements (Ctrl+Shift+M).")
            .arg(withLocalNumbers(QString::fromStdString(text))));
}

}  // namespace macula::viewer
