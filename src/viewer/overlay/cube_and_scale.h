// What stands in the lower right corner of the picture in 3D: a cube that says from where the patient is
// seen, and a bar that says how long something is.
#pragma once

#include <QPointF>
#include <QSize>
#include <memory>
#include <optional>

#include "base/camera.h"
#include "base/frames.h"
#include "live/frame/picture_text.h"
#include "viewer/overlay/scale_bar.h"

namespace macula::viewer {

// The picture that the marks are of.
struct MarkedPicture {
    Camera camera;
    QSize pixels;              // device pixels
    double pixelRatio = 1.0;   // of the screen
    bool isCalibrated = true;  // as in Provenance, of the volume: else a second line says so

    bool operator==(const MarkedPicture&) const = default;
};

// The bar of the picture. With parallel rays it is true everywhere; seen by an eye at the depth of what the
// camera turns around, and there only. Nothing where the picture has no scale.
std::optional<ScaleBar> scaleBarOf(const MarkedPicture& picture);

// Null where the picture is so small that they would cover what is looked at, or for a camera that is none.
// Needs a QGuiApplication.
std::shared_ptr<const app::PictureText> paintCubeAndScale(const MarkedPicture& picture);

// The side of the cube at a place in the picture: -1 to 1, right and up are positive. Nothing beside the
// cube, and where there is none.
std::optional<ViewDirection> cubeSideAt(const MarkedPicture& picture, QPointF place);

}  // namespace macula::viewer
