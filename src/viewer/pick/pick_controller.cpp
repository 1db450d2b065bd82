#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/pick/pick_controller.h"

#include <QMainWindow>

#include "scene/drawing/first_matter.h"
#include "viewer/clip/scissor_tool.h"
#include "viewer/volume/shown_volume.h"

namespace macula::viewer {

PickController::PickController(const WindowContext& context, const ScissorTool& scissors)
    : QObject(&context.window),
      context_(context),
      pick_(this, {.ended = [this](const Result<std::optional<glm::dvec3>>& outcome) {
                if (outcome && *outcome) show(**outcome);
            }}) {
    connect(&context_.viewport, &Viewport::doubleClicked, this, [this, &scissors](QPointF place) {
        if (context_.session.study().volume && !scissors.isOut()) start({place.x(), place.y()});
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
    context_.viewport.centreOn(mm);
    context_.session.change(tr("Cross-hair"), [&](scene::StudyState& next) { next.slices.crosshairMm = mm; });
}

}  // namespace macula::viewer
