#include "viewer/slices/pane_zoom.h"

#include <algorithm>
#include <cmath>

namespace macula::viewer {

PaneZoom::PaneZoom(const PaneContent& content) : content_(content) {}

slices::SlicePlane PaneZoom::plane() const {
    return content_.steps().plane(content_.slice(), view_.centreMm);
}

void PaneZoom::fit() {
    isFitted_ = true;
    Q_EMIT changed();
}

void PaneZoom::follow(const PaneView& view) {
    if (view == view_) return;
    view_ = view;
    told_ = view;
    isFitted_ = false;
    Q_EMIT changed();
}

void PaneZoom::showArea(const scene::SliceArea& area, const glm::ivec2& sizePx) {
    if (!content_.hasStudy() || area.orientation != content_.orientation() || sizePx.x < 1 || sizePx.y < 1)
        return;
    const glm::dvec2 mmPerPx = area.sizeMm / glm::dvec2(sizePx);
    const double coarser = std::max(mmPerPx.x, mmPerPx.y);
    if (!(coarser > 0.0) || !std::isfinite(coarser)) return;
    follow(withinReach({.centreMm = area.centreMm, .mmPerPx = coarser}, plane(), content_.placedVolumes()));
}

void PaneZoom::zoomAt(const QPointF& place, double factor, const glm::ivec2& sizePx) {
    if (!content_.hasStudy()) return;
    const glm::dvec2 fromMiddle = glm::dvec2(place.x(), place.y()) - 0.5 * glm::dvec2(sizePx);
    look(zoomed(view_, plane(), fromMiddle, factor,
                fittedView(content_.volume(), content_.steps(), sizePx).mmPerPx));
}

void PaneZoom::panBy(const glm::dvec2& px) {
    look(panned(view_, plane(), px));
}

void PaneZoom::look(const PaneView& view) {
    isFitted_ = false;
    view_ = withinReach(view, plane(), content_.placedVolumes());
    Q_EMIT changed();
}

void PaneZoom::settle(const glm::ivec2& sizePx) {
    if (isFitted_) view_ = fittedView(content_.volume(), content_.steps(), sizePx);
    // A pane that follows another emits nothing before it has received a view.
    if (told_ == view_ || (!told_ && content_.role() != PaneRole::study)) return;
    told_ = view_;
    Q_EMIT settled(view_);
}

}  // namespace macula::viewer
