// Zoom and position of a pane of slices, as a person or the pane beside it sets them.
#pragma once

#include <QObject>
#include <QPointF>
#include <glm/glm.hpp>
#include <optional>

#include "scene/presentation/softcopy_on_slices.h"
#include "viewer/slices/pane_content.h"

namespace macula::viewer {

// Fits the volume until a person zooms or pans. Sizes and places are in logical pixels of the pane.
class PaneZoom : public QObject {
    Q_OBJECT

  public:
    explicit PaneZoom(const PaneContent& content);  // outlives this

    const PaneView& view() const { return view_; }
    static constexpr double kPerNotch = 1.15;  // of the wheel, or by a key

    // The plane of the current slice, with the middle of the pane as its centre.
    slices::SlicePlane plane() const;

    // Begins another study: fits it, or waits for a view from follow() or showArea().
    void begin(bool isFitted) { isFitted_ = isFitted; }
    void fit();
    void follow(const PaneView& view);  // shows the view of the pane beside it
    void showArea(const scene::SliceArea& area, const glm::ivec2& sizePx);
    void zoomAt(const QPointF& place, double factor, const glm::ivec2& sizePx);
    void panBy(const glm::dvec2& px);

    // Call it before a picture of this size is made. Refits a fitted view, and emits settled() if the view is
    // new.
    void settle(const glm::ivec2& sizePx);

  Q_SIGNALS:
    void changed();                                      // another picture is needed
    void settled(const macula::viewer::PaneView& view);  // for the pane beside it

  private:
    void look(const PaneView& view);  // applies a person's view, limited by withinReach

    const PaneContent& content_;
    PaneView view_;
    std::optional<PaneView> told_;  // the view last emitted by settled()
    bool isFitted_ = true;          // not zoomed or panned since
};

}  // namespace macula::viewer
