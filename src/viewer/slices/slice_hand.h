// The mouse on a pane of slices: what it takes hold of, drags and lets go.
#pragma once

#include <QCursor>
#include <QPointF>
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>

#include "viewer/editor/study_editor.h"
#include "viewer/keys/slice_tool.h"
#include "viewer/settings/mouse_profile.h"
#include "viewer/slices/pane_clip.h"
#include "viewer/slices/pane_curve.h"
#include "viewer/slices/pane_measurements.h"
#include "viewer/slices/pane_turn.h"
#include "viewer/slices/pane_zoom.h"
#include "viewer/slices/slice_brush.h"
#include "viewer/slices/slice_sampler.h"
#include "viewer/slices/slice_travel.h"
#include "viewer/slices/slice_windowing.h"

namespace macula::viewer {

// Passes drags of the mouse to the parts of the pane, which outlive it. `shown` is the request of the picture
// on screen; places are logical pixels of the pane.
class SliceHand {
  public:
    struct Parts {
        StudyEditor& session;
        PaneZoom& zoom;
        SliceTravel& travel;
        SliceWindowing& windowing;
        PaneMeasurements& measurements;
        PaneClip& clip;
        PaneTurn& turn;
        PaneCurve& curve;
    };
    explicit SliceHand(const Parts& parts) : parts_(parts) {}

    SliceTool tool() const { return tool_; }
    void setTool(SliceTool tool) { tool_ = tool; }
    void setBrush(SliceBrush* brush) { brush_ = brush; }  // outlives it; null: none
    double ringMm() const { return tool_ == SliceTool::segment && brush_ ? brush_->radiusMm() : 0.0; }

    bool isHolding() const { return drag_ != Drag::none; }
    bool holdsClip() const { return drag_ == Drag::clip; }
    // False: the button means nothing here.
    bool press(Qt::MouseButton button, const QPointF& place, const SliceRequest& shown);
    struct Pointer {
        QPointF place;
        Qt::MouseButtons buttons;
        Qt::KeyboardModifiers modifiers;
    };
    void move(const Pointer& pointer, const SliceRequest& shown, const glm::ivec2& sizePx);
    // `shown` null: no picture is on screen any more. Returns true for a click with the right button.
    bool release(Qt::MouseButton button, const QPointF& place, const SliceRequest* shown);

    void end();                          // gives up what is held or drawn, and ends its undo step
    void drop() { drag_ = Drag::none; }  // lets go, and ends no undo step
    void loseHandle();                   // the measurement whose handle may be held is gone
    // Selects the measurement there, but does not hold it; false: none, or the tool acts on the picture.
    bool selectAt(const QPointF& place, const SliceRequest& shown);

    Qt::CursorShape usualCursor() const;
    // The cursor over that place; nothing: the cursor stays as it is.
    std::optional<Qt::CursorShape> cursorAt(const QPointF& place, const SliceRequest& shown) const;

  private:
    enum class Drag {
        none,
        crosshair,
        window,
        zoom,
        pan,
        scroll,
        draw,
        handle,
        probe,
        clip,
        turn,
        curve,
        brush
    };

    static bool isUndoStep(Drag drag);
    bool takesHold() const;
    void pressLeft(const QPointF& place, const SliceRequest& shown);
    void pressBrush(const QPointF& place, const SliceRequest& shown);
    bool takeClip(const QPointF& place, const SliceRequest& shown);
    bool takeMeasurement(const QPointF& place, const SliceRequest& shown);
    bool takeRing(const QPointF& place, const SliceRequest& shown);
    Drag dragOfTool() const;
    static Drag dragOf(MouseDrag drag);
    void startLeft(const QPointF& place, const SliceRequest& shown);
    void scrollTo(const QPointF& place);
    bool isStillClick(const QPointF& place) const;
    void dragTo(const Pointer& pointer, const SliceRequest& shown, const glm::ivec2& sizePx);

    Parts parts_;
    SliceBrush* brush_ = nullptr;
    SliceTool tool_ = SliceTool::crosshair;
    Drag drag_ = Drag::none;
    Qt::MouseButton button_ = Qt::NoButton;
    QPointF pressedAt_;
    QPointF lastAt_;
    bool hasDragged_ = false;  // since the press
    double scrollRestPx_ = 0.0;
    std::size_t heldHandle_ = 0;  // of the selected measurement, in Drag::handle
};

}  // namespace macula::viewer
