// The overlay on the picture of a slice.
#pragma once

#include <QColor>
#include <QPainter>
#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "slices/interpolated.h"
#include "slices/measurement.h"
#include "slices/slice_plane.h"

namespace macula::viewer {

struct ShownMeasurement {
    slices::Measurement measurement;
    QString text;  // may be empty
    bool isSelected = false;
    bool hasHandles = true;
};

// The directions of the cross-hair's lines in the picture, y downwards: unit vectors. They are upright and
// level until a person turns the planes.
struct CrosshairLines {
    glm::dvec2 vertical{0.0, 1.0};
    glm::dvec2 horizontal{1.0, 0.0};
};

// What a colour in the picture means.
struct LegendLine {
    QString text;
    QColor ink;  // not valid: that of other texts
};

struct SliceOverlay {
    slices::Orientation orientation = slices::Orientation::axial;
    slices::SliceFrame frame;  // of the picture under the overlay
    double pixelRatio = 1.0;   // device pixels to a logical one
    std::optional<glm::dvec3> crosshairMm = {};
    CrosshairLines lines = {};
    QStringList tags = {};                // upper left: study and date
    QStringList names = {};               // below them, the least important last
    QStringList notes = {};               // upper right
    QStringList facts = {};               // lower left, the least important last
    std::vector<LegendLine> legend = {};  // at the right, below the notes; whole or not at all
    std::vector<ShownMeasurement> measurements = {};
    std::vector<slices::PictureLine> interpolatedEdges = {};  // where voxels come from no image
    bool isCalibrated = true;                                 // Provenance of all that the picture shows
};

// `size` is the pane's, in the painter's logical pixels. overlay_layout.h says where each text is, and what a
// small pane omits.
void paintOverlay(QPainter& painter, const QSize& size, const SliceOverlay& overlay);

}  // namespace macula::viewer
