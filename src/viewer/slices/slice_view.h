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
#include "viewer/keys/slice_tool.h"
#include "viewer/overlay/measurement_handles.h"
#include "viewer/overlay/slice_overlay.h"
#include "viewer/overlay/slice_steps.h"
#include "viewer/session/viewer_session.h"
#include "viewer/slices/clip_on_slice.h"
#include "viewer/slices/measurement_drawing.h"
#include "viewer/slices/measurement_texts.h"
#include "viewer/slices/own_window_list.h"
#include "viewer/slices/pane_view.h"
#include "viewer/slices/second_series.h"
#include "viewer/slices/slice_sampler.h"

namespace macula::viewer {

// Whether a pane shows the second volume when it is beside the study.
enum class PaneRole { study, second };

// Shows the slice that the cross-hair of the session lies in, through its window, with its measurements;
// proposes others of them. Zoom and place are its own. Pictures are made on another thread: until the next is
// there the one before stays, and all that is written, drawn and pointed at is of the one on screen. What is
// between two voxel planes is shown as the nearer one where panes go along voxels. Lives on the UI thread.
class SliceView : public QWidget {
    Q_OBJECT

  public:
    // The session must outlive it.
    SliceView(ViewerSession& session, slices::Orientation orientation, QWidget* parent = nullptr,
              PaneRole role = PaneRole::study);
    ~SliceView() override;

    slices::Orientation orientation() const { return orientation_; }
    SliceTool tool() const { return tool_; }
    void setTool(SliceTool tool);  // gives up what is being drawn

    // Whose pictures these are: written over each, unless hidden.
    void setLines(const QStringList& lines);
    void showNames(bool shown);
    // What the clip removes, dimmed; and where it is taken hold of.
    void showClip(bool shown, bool withHandles);
    // Over the slices of the study that is open; null: none.
    void setSegments(std::shared_ptr<const slices::ShownSegments> segments);

    // Null: there is none. How it is shown is the session's (app::BesideState).
    void setSecond(std::shared_ptr<const SecondSeries> second);
    void setPaneView(const PaneView& view);  // as a pane beside it has it

    // All of that is seen, as large as the pane allows, until a hand zooms or pans; of its own orientation.
    // Nothing where there is no study, or the area is none.
    void showArea(const app::SliceArea& area);
    void fit();                   // the volume fits the pane, and stays so until a hand zooms or pans
    void applyWindow(int digit);  // of app::windowPresets; nothing where there is none
    // Of one's own; null: none are kept. They outlive it.
    void setOwnWindows(OwnWindowList* own) { own_ = own; }
    void applyOwnWindow(int number);    // from 1; nothing where there is none
    void editLabel(std::size_t index);  // of the measurements of the state, which is shown here
    void moveBy(int slices);            // along the normal: of axial ones to the head
    void setCine(bool on);  // goes to and fro through all slices, one step to undo; ends when hidden
    bool isCineOn() const { return cine_.isActive(); }

    // Of the picture on screen; nothing before the first.
    std::optional<slices::SliceFrame> shownFrame() const;
    QString positionText() const;    // as positionText
    QStringList tags() const;        // whose it is, where there is a second volume: names nobody
    QStringList notes() const;       // what has to be known of it: slab, inverted, interpolated
    QString probedText() const;      // of what the pointer is on; empty outside of the pane
    QString overProbedText() const;  // the same, of a second volume in colours
    bool isUpToDate() const;         // it is of what is chosen
    std::optional<std::size_t> selected() const { return selected_; }  // of the measurements of the state

    QSize sizeHint() const override { return {360, 360}; }
    QSize minimumSizeHint() const override { return {120, 120}; }

  signals:
    void maximizeAsked();
    void cineChanged(bool on);
    void pictureShown();
    void viewChanged(const macula::viewer::PaneView& view);  // by a hand, or to fit

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
    void onChanged(const app::StudyState& before);
    void onPicture(SlicePicture picture);
    void request();
    void followSelection(const app::StudyState& before);

    const Volume& volume() const { return *session_.study().measured(); }
    glm::dvec3 crosshairMm() const;
    DisplayWindow window() const;  // of what the pane is to show
    DisplayWindow studyWindow() const;
    int slice() const { return steps_->nearest(crosshairMm()); }
    slices::SlicePlane plane() const { return steps_->plane(slice(), view_.centreMm); }
    glm::dvec3 worldAt(const QPointF& place) const;  // of the picture on screen, which must be
    bool isShownHere(const slices::Measurement& measurement) const;

    const app::BesideState* beside() const;
    bool wantsSecond() const;  // in the place of the study
    const Volume& wantedVolume() const;
    DisplayWindow secondWindow() const;
    bool secondIsInverted() const;
    void addSecond(SliceWish& wish) const;
    void proposeWindow(const std::optional<DisplayWindow>& window, bool isDrag);
    void moveSecond(int slices);
    bool isMeasuring() const;  // the tool does
    bool showsStudy() const { return shown_ && shown_->of.shows == SliceShows::study; }

    void goTo(int slice, const QString& what);
    void cineStep();
    void zoomAt(const QPointF& place, double factor);
    void look(const PaneView& view);  // by a hand: never beside all volumes
    std::vector<PlacedGrid> placedVolumes() const;
    void press(const QPointF& place);
    void dragTo(const QPointF& place);
    void endGesture();
    bool takesHold() const;
    bool takeClip(const QPointF& place);
    bool takeMeasurement(const QPointF& place);
    std::optional<app::PlacedHandle> clipHandleAt(const QPointF& place) const;
    void moveClip(const QPointF& place);
    void showCursorAt(const QPointF& place);
    void moveHandle(const QPointF& place);
    void setCrosshair(const glm::dvec3& mm);
    std::vector<SliceRange> shownInterpolated() const;
    QString interpolatedNote() const;
    QString secondPositionText(const app::BesideState& state, SliceWish& wish) const;
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

    ViewerSession& session_;
    slices::Orientation orientation_;
    PaneRole role_;
    std::unique_ptr<SliceSampler> sampler_;

    std::uint64_t study_ = 0;          // counts those that were shown
    DisplayWindow usualWindow_;        // of the study: seriesWindow
    std::optional<SliceSteps> steps_;  // nothing: no study
    PaneView view_;
    std::optional<PaneView> told_;  // by viewChanged
    bool isFitted_ = true;          // no hand has zoomed or panned
    std::shared_ptr<const SecondSeries> second_;
    std::optional<SliceWish> wanted_;
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
    bool hasDragged_ = false;  // since the button went down
    std::optional<QPointF> hoverAt_;
    int wheelRest_ = 0;  // eighths of a degree that made no notch yet
    QTimer wheelEnds_;   // what is turned or stepped until then is one step to undo

    std::optional<MeasurementDrawing> drawing_;
    std::optional<std::size_t> selected_;
    std::size_t heldHandle_ = 0;  // of the selected one, in Drag::handle
    bool showsClip_ = true;
    bool hasClipHandles_ = false;
    std::optional<app::ClipHandle> heldClip_;  // in Drag::clip
    MeasurementTexts texts_;
    OwnWindowList* own_ = nullptr;

    QTimer cine_;
    bool cineGoesBack_ = false;
};

}  // namespace macula::viewer
