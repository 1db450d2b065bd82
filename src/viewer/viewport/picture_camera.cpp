#include "viewer/viewport/picture_camera.h"

#include <QKeyEvent>
#include <QPointF>
#include <cmath>
#include <optional>
#include <utility>

#include "scene/camera/usual_view.h"
#include "viewer/keys/keys.h"

namespace macula::viewer {

namespace {

constexpr double kVerticalFovDeg = 30.0;
constexpr double kFlyOfDiagonal = 0.03;  // per notch of the wheel
constexpr double kNoSceneMm = 1000.0;

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

PictureCamera::PictureCamera(std::function<double()> aspect) : aspect_(std::move(aspect)) {}

void PictureCamera::setVolume(std::shared_ptr<const Volume> volume) {
    volume_ = std::move(volume);
    outline_.reset();
}

void PictureCamera::takeOutline(std::shared_ptr<const std::vector<glm::dvec3>> pointsMm) {
    if (!volume_) return;
    const bool isFirst = !outline_;
    outline_ = std::move(pointsMm);
    if (isFirst && untouched_) showFrom(framedFrom_);
}

void PictureCamera::refit() {
    if (untouched_ && volume_)
        camera_ = scene::fitted(scene::turnedTo(camera_, framedFrom_), fittedPointsMm(), aspect_());
}

void PictureCamera::showFirst(std::optional<ViewDirection> from) {
    if (!volume_) return;
    firstFrom_ = scene::firstDirection(from, *volume_);
    showFrom(firstFrom_);
}

void PictureCamera::showFrom(ViewDirection from) {
    if (!volume_) return;
    framedFrom_ = from;
    scene::OrbitCamera camera = scene::turnedTo(camera_, framedFrom_);
    camera.verticalFovDeg = kVerticalFovDeg;
    set(scene::fitted(camera, fittedPointsMm(), aspect_()));
    untouched_ = true;
}

void PictureCamera::showFrom(const Camera& camera) {
    if (volume_) set(scene::orbitCameraOf(camera));
}

void PictureCamera::centreOn(const glm::dvec3& mm) {
    if (!volume_) return;
    scene::OrbitCamera camera = camera_;
    camera.targetMm = mm;
    set(camera);
}

void PictureCamera::fit() {
    if (volume_) set(scene::fitted(camera_, fittedPointsMm(), aspect_()));
}

void PictureCamera::set(const scene::OrbitCamera& camera) {
    const bool wasParallel = std::exchange(camera_, camera).isParallel;
    untouched_ = false;
    Q_EMIT changed();
    if (camera_.isParallel != wasParallel) Q_EMIT parallelChanged(camera_.isParallel);
    Q_EMIT moved();
}

void PictureCamera::setParallel(bool isParallel) {
    if (isParallel == camera_.isParallel) return;
    const bool untouched = untouched_;
    scene::OrbitCamera camera = camera_;
    camera.isParallel = isParallel;
    set(camera);
    untouched_ = untouched;
}

void PictureCamera::zoomBy(double magnification) {
    set(zoomed(camera_, magnification, sceneDiagonalMm()));
}

// With parallel rays flying would change nothing: it magnifies instead.
void PictureCamera::flyBy(double notches) {
    if (camera_.isParallel) return zoomBy(std::pow(kZoomPerNotch, notches));
    set(flown(camera_, notches * kFlyOfDiagonal * sceneDiagonalMm(), volume_->worldBox()));
}

double PictureCamera::sceneDiagonalMm() const {
    return volume_ ? volume_->worldBox().diagonal() : kNoSceneMm;
}

// Until the outline is known, and in projections, the whole volume.
std::vector<glm::dvec3> PictureCamera::fittedPointsMm() const {
    if (outline_ && !outline_->empty() && !isProjection_) return *outline_;
    const auto corners = cornersOf(volume_->worldBox());
    return {corners.begin(), corners.end()};
}

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
