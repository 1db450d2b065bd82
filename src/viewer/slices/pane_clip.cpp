#include "viewer/slices/pane_clip.h"

namespace macula::viewer {

namespace {

constexpr double kHandleHitPx = 8.0;  // logical

}  // namespace

bool PaneClip::show(bool shown, bool withHandles) {
    if (shown == isShown_ && withHandles == hasHandles_) return false;
    isShown_ = shown;
    hasHandles_ = withHandles;
    return true;
}

std::optional<scene::PlacedHandle> PaneClip::handleAt(const QPointF& place, const SliceRequest& shown) const {
    if (!isShown_ || !hasHandles_ || !shown.showsStudy()) return std::nullopt;
    const scene::StudyState& state = session_.state();
    return viewer::handleAt(scene::handlesOn(shown.frame, state.clip, state.cuts, volume()), shown.frame,
                            shown.frameFromPane(place), kHandleHitPx * shown.pixelRatio);
}

void PaneClip::dragTo(const QPointF& place, const SliceRequest& shown) {
    if (!held_ || !shown.showsStudy()) return;
    const scene::StudyState& state = session_.state();
    const glm::dvec3 mm =
        scene::draggedTo(*held_, shown.worldFromPane(place), shown.frame, state.clip, volume());
    const auto moved = scene::withHandleAt(state.clip, state.cuts, *held_, mm, volume());
    if (!moved) return;
    session_.drag(tr("Clip"), [&](scene::StudyState& next) {
        next.clip = moved->clip;
        next.cuts = moved->cuts;
    });
}

void PaneClip::paint(QPainter& painter, const QSize& size, const SliceRequest& shown,
                     const std::optional<QPointF>& pointedAt) {
    if (!isShown_ || !shown.showsStudy()) return;
    ClipOnSlice clip = clipOnSlice(session_.state(), volume(), shown.frame, hasHandles_);
    const auto pointed = pointedAt ? handleAt(*pointedAt, shown) : std::nullopt;
    clip.held = held_ ? held_ : pointed ? std::optional(pointed->handle) : std::nullopt;
    paintClip(painter, size, clip, shown.frame, shown.pixelRatio, dimming_);
}

}  // namespace macula::viewer
