// A pane that shows slices of the study, in one orientation.
#pragma once

#include <QString>
#include <QStringList>
#include <QTimer>
#include <QWidget>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "scene/clip/clip_handles.h"
#include "scene/presentation/softcopy_on_slices.h"
#include "slices/slice_plane.h"
#include "viewer/editor/study_editor.h"
#include "viewer/keys/slice_tool.h"
#include "viewer/overlay/measurement_handles.h"
#include "viewer/overlay/slice_overlay.h"
#include "viewer/overlay/slice_steps.h"
#include "viewer/slices/clip_on_slice.h"
#include "viewer/slices/measurement_drawing.h"
#include "viewer/slices/measurement_texts.h"
#include "viewer/slices/own_window_list.h"
#include "viewer/slices/pane_view.h"
#include "viewer/slices/second_volume_texts.h"
#include "viewer/slices/slice_sampler.h"

namespace macula::viewer {

// Whether a pane shows the second volume when it is beside the study.
enum class PaneRole { study, second };

// Shows the slice through the session's cross-hair, with its window and measurements, and proposes changes of
// these. Zoom and position are its own. Another thread makes the pictures: the old picture stays until the
// next, and overlay and pointer refer to the picture on screen. Where planes follow voxel planes, a
// cross-hair between two planes shows the nearer one. Lives on the UI thread.
class SliceView : public QWidget {
    Q_OBJECT

  public:
    // The session must outlive it.
    SliceView(StudyEditor& session, slices::Orientation orientation, QWidget* parent = nullptr,
              PaneRole role = PaneRole::study);
    ~SliceView() override;

    slices::Orientation orientation() const { return orientation_; }
    SliceTool tool() const { return tool_; }
    void setTool(SliceTool tool);  // ends an unfinished gesture

    // Lines that identify the study, over each picture unless hidden.
    void setLines(const QStringList& lines);
    void showNames(bool shown);
    // Dims what the clip removes; optionally with its handles.
    void showClip(bool shown, bool withHandles);
    // Segments over the slices of the open study; null: none.
    void setSegments(std::shared_ptr<const slices::ShownSegments> segments);

    // Null: no second volume. The session says how to show it (scene::SecondVolumeState).
    void setSecond(std::shared_ptr<const SecondVolumeTexts> second);
    void setPaneView(const PaneView& view);  // as in the pane beside it

    // Shows that whole area as large as the pane allows, until a person zooms or pans. Does nothing without a
    // study, for another orientation, or for an unusable area.
    void showArea(const scene::SliceArea& area);
    void fit();                   // fits the volume, until a person zooms or pans
    void applyWindow(int digit);  // of scene::windowPresets; an unknown one does nothing
    // The own windows; null: none. The list outlives it.
    void setOwnWindows(OwnWindowList* own) { own_ = own; }
    void applyOwnWindow(int number);    // from 1; an unknown one does nothing
    void editLabel(std::size_t index);  // an index into the state's measurements, shown here
    void moveBy(int slices);            // along the normal: for axial slices to the head
    void setCine(bool on);              // runs to and fro, one undo step; ends when hidden
    bool isCineOn() const { return cine_.isActive(); }

    // The frame of the picture on screen; nothing before the first.
    std::optional<slices::SliceFrame> shownFrame() const;
    QString positionText() const;    // as positionText
    QStringList tags() const;        // identify the volume beside another; without names
    QStringList notes() const;       // warnings: slab, inverted, interpolated
    QString probedText() const;      // the value under the pointer; empty outside the pane
    QString overProbedText() const;  // the same, of a second volume in colours
    bool isUpToDate() const;         // the picture on screen shows the current state
    std::optional<std::size_t> selected() const { return selected_; }  // of the measurements of the state

    QSize sizeHint() const override { return {360, 360}; }
    QSize minimumSizeHint() const override { return {120, 120}; }

  signals:
    void maximizeAsked();
    void cineChanged(bool on);
    void pictureShown();
    void viewChanged(const macula::viewer::PaneView& view);  // by a person, or by fitting

  protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    enum class Drag { none, crosshair, window, zoom, pan, draw, handle, probe, clip };

    void onStudyShown();
    void onChanged(const scene::StudyState& before);
    void onPicture(SlicePicture picture);
    void request();
    void followSelection(const scene::StudyState& before);

    const Volume& volume() const { return *session_.study().measured(); }
    glm::dvec3 crosshairMm() const;
    DisplayWindow window() const;  // of the volume that the pane is to show
    DisplayWindow studyWindow() const;
    int slice() const { return steps_->nearest(crosshairMm()); }
    slices::SlicePlane plane() const { return steps_->plane(slice(), view_.centreMm); }
    glm::dvec3 worldAt(const QPointF& place) const;  // needs a picture on screen
    bool isShownHere(const slices::Measurement& measurement) const;

    const scene::SecondVolumeState* secondVolume() const;
    bool wantsSecond() const;  // instead of the study
    const Volume& wantedVolume() const;
    DisplayWindow secondWindow() const;
    bool secondIsInverted() const;
    void addSecond(SliceRequest& request) const;
    void proposeWindow(const std::optional<DisplayWindow>& window, bool isDrag);
    void moveSecond(int slices);
    bool isMeasuring() const;  // the tool does
    bool showsStudy() const { return shown_ && shown_->of.shows == SliceShows::study; }

    void goTo(int slice, const QString& what);
    void cineStep();
    void zoomAt(const QPointF& place, double factor);
    void look(const PaneView& view);  // by a person: limited by withinReach
    std::vector<PlacedGrid> placedVolumes() const;
    void press(const QPointF& place);
    void dragTo(const QPointF& place);
    void endGesture();
    bool takesHold() const;
    bool takeClip(const QPointF& place);
    bool takeMeasurement(const QPointF& place);
    std::optional<scene::PlacedHandle> clipHandleAt(const QPointF& place) const;
    void moveClip(const QPointF& place);
    void showCursorAt(const QPointF& place);
    void moveHandle(const QPointF& place);
    void setCrosshair(const glm::dvec3& mm);
    std::vector<SliceRange> shownInterpolated() const;
    QString interpolatedNote() const;
    QString secondPositionText(const scene::SecondVolumeState& state, SliceRequest& request) const;
    void finishDrawing();
    void removeSelected();
    void showMenu(const QPointF& place);
    bool isStillClick(const QPointF& place) const;
    bool handleKey(int key, bool withShift);
    void endOwnDrag(const QString& what);

    void paintPicture(QPainter& painter);
    SliceOverlay overlay();
    std::vector<ShownMeasurement> shownMeasurements();
    QString segmentText(const glm::dvec3& mm) const;
    QStringList segmentNotes() const;
    QString textOf(const slices::Measurement& measurement);
    QString textWhileDrawn(const slices::Measurement& measurement);

    StudyEditor& session_;
    slices::Orientation orientation_;
    PaneRole role_;
    std::unique_ptr<SliceSampler> sampler_;

    std::uint64_t study_ = 0;          // counts the studies shown
    DisplayWindow usualWindow_;        // of the study: seriesWindow
    std::optional<SliceSteps> steps_;  // nothing: no study
    PaneView view_;
    std::optional<PaneView> told_;  // the view last emitted by viewChanged
    bool isFitted_ = true;          // not zoomed or panned since
    std::shared_ptr<const SecondVolumeTexts> second_;
    std::optional<SliceRequest> wanted_;
    std::optional<SlicePicture> shown_;
    ClipDimming dimming_;
    std::shared_ptr<const slices::ShownSegments> segments_;
    QStringList lines_;
    bool namesShown_ = true;

    SliceTool tool_ = SliceTool::crosshair;
    Drag drag_ = Drag::none;
    Qt::MouseButton dragButton_ = Qt::NoButton;
    QPointF pressedAt_;
    QPointF lastAt_;
    bool hasDragged_ = false;  // since the press
    std::optional<QPointF> hoverAt_;
    int wheelRest_ = 0;  // eighths of a degree, less than a notch
    QTimer wheelEnds_;   // wheel and key steps until then are one undo step

    std::optional<MeasurementDrawing> drawing_;
    std::optional<std::size_t> selected_;
    std::size_t heldHandle_ = 0;  // of the selected measurement, in Drag::handle
    bool showsClip_ = true;
    bool hasClipHandles_ = false;
    std::optional<scene::ClipHandle> heldClip_;  // in Drag::clip
    MeasurementTexts texts_;
    OwnWindowList* own_ = nullptr;

    QTimer cine_;
    bool cineGoesBack_ = false;
};

}  // namespace macula::viewer
