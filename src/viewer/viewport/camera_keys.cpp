#include "viewer/viewport/camera_keys.h"

#include <QKeyEvent>
#include <QPointF>
#include <optional>
#include <utility>

#include "viewer/keys/keys.h"

namespace macula::viewer {

namespace {

constexpr double kOrbitStepDeg = 5.0;
constexpr double kPanStepOfHeight = 0.05;
constexpr double kRollStepDeg = 5.0;

// The direction of an arrow key; right and down are positive.
std::optional<QPointF> arrowOfKey(int key) {
    switch (key) {
        case Qt::Key_Left:
            return QPointF(-1, 0);
        case Qt::Key_Right:
            return QPointF(1, 0);
        case Qt::Key_Up:
            return QPointF(0, -1);
        case Qt::Key_Down:
            return QPointF(0, 1);
        default:
            return std::nullopt;
    }
}

}  // namespace

CameraKeys::CameraKeys(PictureCamera& camera, std::function<void()> nudge)
    : camera_(camera), nudge_(std::move(nudge)) {}

bool CameraKeys::roll(const QKeyEvent& event) {
    const bool control = event.modifiers().testFlag(Qt::ControlModifier);
    const auto is = [&](Qt::Key bracket, Qt::Key arrow) {
        // Many keyboards need AltGr for brackets, which some platforms report as Ctrl and Alt.
        return event.key() == bracket || (control && event.key() == arrow);
    };
    const bool clockwise = is(Qt::Key_BracketRight, Qt::Key_Right);
    if (!clockwise && !is(Qt::Key_BracketLeft, Qt::Key_Left)) return false;
    nudge_();
    camera_.set(rolled(camera_.now(), clockwise ? kRollStepDeg : -kRollStepDeg));
    return true;
}

bool CameraKeys::move(const QKeyEvent& event) {
    const auto arrow = arrowOfKey(event.key());
    if (!arrow) return false;
    nudge_();
    if (event.modifiers().testFlag(Qt::ShiftModifier)) {
        camera_.set(scene::pannedByDrag(camera_.now(), arrow->x() * kPanStepOfHeight,
                                        arrow->y() * kPanStepOfHeight, 1));
    } else {
        // The eye moves in the direction of the arrow.
        camera_.set(orbited(camera_.now(), arrow->x() * kOrbitStepDeg, -arrow->y() * kOrbitStepDeg));
    }
    return true;
}

bool CameraKeys::look(const QKeyEvent& event) {
    const std::optional<KeyAction> action = actionOf(event);
    if (action == KeyAction::fit) return camera_.fit(), true;
    if (action == KeyAction::parallel) return camera_.setParallel(!camera_.now().isParallel), true;
    if (const auto view = action ? viewDirectionOf(*action) : std::nullopt)
        return camera_.showFrom(*view), true;
    switch (event.key()) {
        case Qt::Key_Plus:
        case Qt::Key_Equal:  // the same key without shift on many keyboards
            nudge_();
            return camera_.zoomBy(PictureCamera::kZoomPerNotch), true;
        case Qt::Key_Minus:
            nudge_();
            return camera_.zoomBy(1.0 / PictureCamera::kZoomPerNotch), true;
        default:
            return false;
    }
}

}  // namespace macula::viewer
