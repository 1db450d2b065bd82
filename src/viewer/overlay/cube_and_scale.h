// The marks in the lower right corner of the 3D picture: a cube for the direction of view, and a scale bar.
#pragma once

#include <QPointF>
#include <QSize>
#include <QString>
#include <memory>
#include <optional>

#include "base/camera.h"
#include "base/frames.h"
#include "live/frame/picture_text.h"

namespace macula::viewer {

struct ScaleBar {
    double lengthMm = 0.0;  // 1, 2 or 5 times a power of ten
    double lengthPx = 0.0;
    QString text;  // "5 cm", "2 mm", "0.5 mm"; "≈ 5 cm" for an estimate
    bool isCalibrated = true;
};

// The longest bar of at most `mostPx`. Nothing unless `mmPerPx` is a positive number. `isCalibrated`:
// Provenance of what the picture shows.
std::optional<ScaleBar> scaleBar(double mmPerPx, double mostPx, bool isCalibrated);

// The picture that the marks describe.
struct MarkedPicture {
    Camera camera;
    QSize pixels;              // device pixels
    double pixelRatio = 1.0;   // of the screen
    bool isCalibrated = true;  // Provenance of the volume; if false, a second line says so

    bool operator==(const MarkedPicture&) const = default;
};

// The scale bar. With parallel rays it holds everywhere, in perspective only at the depth of the camera's
// target. Nothing for a picture without a scale.
std::optional<ScaleBar> scaleBarOf(const MarkedPicture& picture);

// Null for a picture so small that the marks would cover its subject, or for an unusable camera. Needs a
// QGuiApplication.
std::shared_ptr<const live::PictureText> paintCubeAndScale(const MarkedPicture& picture);

// The side of the cube at a place in the picture: -1 to 1, right and up are positive. Nothing outside the
// cube or without a cube.
std::optional<ViewDirection> cubeSideAt(const MarkedPicture& picture, QPointF place);

}  // namespace macula::viewer
