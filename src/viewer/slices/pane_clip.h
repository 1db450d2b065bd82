// The clip on a pane of slices: dims what it removes, and moves its handles.
#pragma once

#include <QCoreApplication>
#include <QPainter>
#include <QPointF>
#include <QSize>
#include <optional>

#include "scene/clip/clip_handles.h"
#include "viewer/editor/study_editor.h"
#include "viewer/slices/clip_on_slice.h"
#include "viewer/slices/slice_sampler.h"

namespace macula::viewer {

// Proposes changes of the session's clip, which clips the study and never the second volume. `shown` is the
// request of the picture on screen; places are logical pixels of the pane.
class PaneClip {
    Q_DECLARE_TR_FUNCTIONS(PaneClip)

  public:
    explicit PaneClip(StudyEditor& session) : session_(session) {}  // outlives this

    // Returns whether anything changed.
    bool show(bool shown, bool withHandles);
    bool hasHandles() const { return hasHandles_; }
    std::optional<scene::PlacedHandle> handleAt(const QPointF& place, const SliceRequest& shown) const;

    void hold(const scene::ClipHandle& handle) { held_ = handle; }
    void letGo() { held_.reset(); }
    // Moves the held handle. It stays where it is if the clip refuses the move.
    void dragTo(const QPointF& place, const SliceRequest& shown);

    // `pointedAt`: the place of the pointer; nothing: outside of the pane.
    void paint(QPainter& painter, const QSize& size, const SliceRequest& shown,
               const std::optional<QPointF>& pointedAt);

  private:
    const Volume& volume() const { return *session_.study().measured(); }

    StudyEditor& session_;
    bool isShown_ = true;
    bool hasHandles_ = false;
    std::optional<scene::ClipHandle> held_;
    ClipDimming dimming_;
};

}  // namespace macula::viewer
