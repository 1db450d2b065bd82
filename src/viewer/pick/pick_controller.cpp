#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/pick/pick_controller.h"

#include <QMainWindow>

#include "viewer/clip/scissor_tool.h"
#include "viewer/pick/anatomy_pick.h"
#include "viewer/volume/shown_volume.h"

namespace macula::viewer {

PickController::PickController(const WindowContext& context, const ScissorTool& scissors)
    : QObject(&context.window), context_(context), pick_(new AnatomyPick(this)) {
    connect(&context_.viewport, &Viewport::doubleClicked, this, [this, &scissors](QPointF place) {
        const auto& volume = context_.session.study().volume;
        if (volume && !scissors.isOut())
            pick_->start(volume, context_.shown.drawing(), toCamera(context_.viewport.camera()),
                         {place.x(), place.y()}, context_.viewport.aspect());
    });
    connect(pick_, &AnatomyPick::found, this, [this](const glm::dvec3& mm) {
        context_.viewport.centreOn(mm);
        context_.session.change(tr("Cross-hair"),
                                [&](scene::StudyState& next) { next.slices.crosshairMm = mm; });
    });
}

void PickController::cancel() {
    pick_->cancel();
}

}  // namespace macula::viewer
