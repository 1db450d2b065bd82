// Draws a clip on a slice: dims the part that it removes, and adds lines for its borders and handles to drag.
#pragma once

#include <QCursor>
#include <QImage>
#include <QPainter>
#include <QSize>
#include <optional>
#include <vector>

#include "scene/clip/clip_handles.h"
#include "scene/clip/removed_on_slice.h"
#include "scene/state/study_state.h"
#include "slices/slice_plane.h"

namespace macula::viewer {

// Contours are in device pixels of the picture.
struct ClipOnSlice {
    std::vector<scene::Contour> removed;  // filled by winding
    struct Scissors {
        std::vector<scene::Contour> behind;
        bool removesOutside = false;

        bool operator==(const Scissors&) const = default;
    };
    std::vector<Scissors> scissors;
    std::vector<scene::Contour> lines;
    std::vector<scene::PlacedHandle> handles;
    std::optional<scene::ClipHandle> held;  // the handle that is held or pointed at

    bool isNothing() const { return removed.empty() && scissors.empty() && lines.empty() && handles.empty(); }
};

// Made from the state's clip and cuts; has handles only if `withHandles`.
ClipOnSlice clipOnSlice(const scene::StudyState& state, const Volume& volume, const slices::SliceFrame& frame,
                        bool withHandles);

// Caches the dimmed area of a pane as one image over the slice, while clip, slice and size stay the same and
// only cross-hair or pointer move.
class ClipDimming {
  public:
    // `size` in logical pixels. A null image if nothing is dimmed or memory is short.
    const QImage& imageFor(const ClipOnSlice& clip, const QSize& size, double pixelRatio);

  private:
    std::vector<scene::Contour> removed_;
    std::vector<ClipOnSlice::Scissors> scissors_;
    QSize size_;
    double pixelRatio_ = 0.0;
    QImage image_;
};

// `size` is the pane's, in the painter's logical pixels.
void paintClip(QPainter& painter, const QSize& size, const ClipOnSlice& clip, const slices::SliceFrame& frame,
               double pixelRatio, ClipDimming& dimming);

// The nearest handle within `radiusPx` of a place in the picture.
std::optional<scene::PlacedHandle> handleAt(const std::vector<scene::PlacedHandle>& handles,
                                            const slices::SliceFrame& frame, const glm::dvec2& px,
                                            double radiusPx);

// A cursor for motion along a direction of the picture, y downwards; zero: in any direction.
Qt::CursorShape cursorAlong(const glm::dvec2& along);
Qt::CursorShape cursorOf(const scene::PlacedHandle& handle, const slices::SlicePlane& plane);

}  // namespace macula::viewer
