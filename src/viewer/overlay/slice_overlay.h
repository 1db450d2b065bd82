// What is drawn over the picture of a slice.
#pragma once

#include <QPainter>
#include <QSize>
#include <QStringList>
#include <optional>
#include <vector>

#include "slices/interpolated.h"
#include "slices/measurement.h"
#include "slices/slice_plane.h"

namespace macula::viewer {

struct ShownMeasurement {
    slices::Measurement measurement;
    QString text;
    bool isSelected = false;
};

struct SliceOverlay {
    slices::Orientation orientation = slices::Orientation::axial;
    slices::SliceFrame frame;  // of the picture below, in device pixels
    double pixelRatio = 1.0;   // device pixels to a logical one
    std::optional<glm::dvec3> crosshairMm = {};
    QStringList tags = {};   // upper left: which study it is, and of which day
    QStringList names = {};  // below them; what matters least comes last
    QStringList notes = {};  // upper right
    QStringList facts = {};  // lower left; likewise
    std::vector<ShownMeasurement> measurements = {};
    std::vector<slices::PictureLine> interpolatedEdges = {};  // of slices in which no image was taken
    bool isCalibrated = true;                                 // as in Provenance, all that is in the picture
};

// `size` of the pane in logical pixels, which the painter must have. What stands where, and what goes in a
// small pane: overlay_layout.h.
void paintOverlay(QPainter& painter, const QSize& size, const SliceOverlay& overlay);

}  // namespace macula::viewer
