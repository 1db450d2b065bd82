#include "viewer/viewport/picture_camera.h"

#include <cmath>
#include <utility>

#include "scene/camera/usual_view.h"

namespace macula::viewer {

namespace {

constexpr double kVerticalFovDeg = 30.0;
constexpr double kFlyOfDiagonal = 0.03;  // per notch of the wheel
constexpr double kNoSceneMm = 1000.0;

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

}  // namespace macula::viewer
