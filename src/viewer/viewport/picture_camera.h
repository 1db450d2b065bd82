// The camera of the 3D picture, the side of the study that it was fitted from, and the keys that move it.
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/volume.h"
#include "scene/camera/orbit_camera.h"

class QKeyEvent;

namespace macula::viewer {

// Fits the visible part of the volume until a person moves the camera. Needs no window.
class PictureCamera : public QObject {
    Q_OBJECT

  public:
    // `aspect` returns width over height of the picture.
    explicit PictureCamera(std::function<double()> aspect);

    const scene::OrbitCamera& now() const { return camera_; }
    // The side of a camera that still fits the visible part; nothing after it was moved, or with parallel
    // rays.
    std::optional<ViewDirection> framedFrom() const {
        return untouched_ && !camera_.isParallel ? std::optional(framedFrom_) : std::nullopt;
    }
    ViewDirection firstFrom() const { return firstFrom_; }  // the side from which the study was shown first

    // Begins another study, or none if it is null. Its visible part is not known yet.
    void setVolume(std::shared_ptr<const Volume> volume);
    void setProjection(bool isProjection) { isProjection_ = isProjection; }  // shows the whole volume
    // Sets points around the visible part. The first ones of a study move a camera that nobody has touched.
    // Later ones, from other presets, do not: pictures to compare keep their view.
    void takeOutline(std::shared_ptr<const std::vector<glm::dvec3>> pointsMm);
    void refit();  // for another aspect, unless it was moved; emits nothing

    // The first five do nothing without a volume. showFirst uses the usual view if `from` is nothing.
    void showFirst(std::optional<ViewDirection> from);
    void showFrom(ViewDirection from);
    void showFrom(const Camera& camera);
    void centreOn(const glm::dvec3& mm);
    void fit();
    void set(const scene::OrbitCamera& camera);
    void setParallel(bool isParallel);  // an untouched camera stays untouched

    void zoomBy(double magnification);
    void flyBy(double notches);  // needs a volume; with parallel rays it zooms

    static constexpr double kZoomPerNotch = 1.15;  // of a wheel, or by a key

  Q_SIGNALS:
    void changed();
    void parallelChanged(bool isParallel);
    void moved();  // after the other two

  private:
    double sceneDiagonalMm() const;
    std::vector<glm::dvec3> fittedPointsMm() const;

    std::function<double()> aspect_;
    std::shared_ptr<const Volume> volume_;
    bool isProjection_ = false;
    scene::OrbitCamera camera_;
    ViewDirection firstFrom_ = ViewDirection::anterior;
    ViewDirection framedFrom_ = ViewDirection::anterior;
    bool untouched_ = true;                                   // not moved since it was framed
    std::shared_ptr<const std::vector<glm::dvec3>> outline_;  // null until the study's first
};

class CameraKeys {
  public:
    // The camera outlives this. `nudge` is called before a step of a key that may be held down.
    CameraKeys(PictureCamera& camera, std::function<void()> nudge);

    // Each returns whether it handled the key. roll(): [, ] and Ctrl with arrows. move(): arrows. look():
    // standard views, fit, parallel, + and -. Call move() and look() only without modifiers other than Shift.
    bool roll(const QKeyEvent& event);
    bool move(const QKeyEvent& event);
    bool look(const QKeyEvent& event);

  private:
    PictureCamera& camera_;
    std::function<void()> nudge_;
};

}  // namespace macula::viewer
