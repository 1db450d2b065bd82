// The texts over the picture of a slice: notes, the value under the pointer, and facts.
#pragma once

#include <QPointF>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "slices/interpolated.h"
#include "viewer/overlay/slice_overlay.h"
#include "viewer/slices/slice_sampler.h"

namespace macula::viewer {

// Warnings: slab, inverted, interpolated. `areAcquired`: SliceSteps::areAcquired of the study; `isMeasuring`:
// a measuring tool is chosen.
QStringList notesOf(const SlicePicture& shown, bool areAcquired, bool isMeasuring);

// The value at a place in the pane, in logical pixels, with the segments that are shown there.
QString probedText(const SliceRequest& shown, const QPointF& place);
// The same for a second volume in colours; empty where none lies over the picture.
QString overProbedText(const SliceRequest& shown, const QPointF& place);

// The overlay of the picture, with the values at `pointedAt` if the pointer is in the pane. Its notes, names
// and measurements are left empty; the cross-hair is that of the request.
SliceOverlay overlayOf(const SliceRequest& shown, slices::Orientation orientation,
                       const std::optional<QPointF>& pointedAt);

}  // namespace macula::viewer
