// A pane that shows slices of the study, in one orientation.
#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>
#include <cstddef>
#include <memory>
#include <optional>

#include "scene/presentation/softcopy_on_slices.h"
#include "slices/slice_plane.h"
#include "viewer/editor/study_editor.h"
#include "viewer/keys/slice_tool.h"
#include "viewer/slices/pane_clip.h"
#include "viewer/slices/pane_content.h"
#include "viewer/slices/pane_measurements.h"
#include "viewer/slices/pane_picture.h"
#include "viewer/slices/pane_zoom.h"
#include "viewer/slices/second_volume_texts.h"
#include "viewer/slices/slice_hand.h"
#include "viewer/slices/slice_keys.h"
#include "viewer/slices/slice_painting.h"
#include "viewer/slices/slice_popups.h"
#include "viewer/slices/slice_travel.h"
#include "viewer/slices/slice_windowing.h"

namespace macula::viewer {

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

    slices::Orientation orientation() const { return content_.orientation(); }
    SliceTool tool() const { return hand_.tool(); }
    void setTool(SliceTool tool);  // ends an unfinished gesture

    // Lines that identify the study, over each picture unless hidden.
    void setLines(const QStringList& lines);
    void showNames(bool shown);
    // Dims what the clip removes; optionally with its handles.
    void showClip(bool shown, bool withHandles);
    // Segments over the slices of the open study; null: none.
    void setSegments(std::shared_ptr<const slices::ShownSegments> segments);
    void setBrush(SliceBrush* brush) { hand_.setBrush(brush); }  // for SliceTool::segment; outlives it

    // Another phase of the study in its place, and a text that says which; null: the study itself.
    // `ofDifference` as in PaneContent::setPhase.
    void setPhase(std::shared_ptr<const study::OpenedStudy> phase, const QString& text,
                  std::optional<DisplayWindow> ofDifference = std::nullopt);
    // Null: no second volume. The session says how to show it (scene::SecondVolumeState).
    void setSecond(std::shared_ptr<const SecondVolumeTexts> second);
    void setPaneView(const PaneView& view) { zoom_.follow(view); }  // follows the pane beside it

    // Shows that whole area as large as the pane allows, until a person zooms or pans. Does nothing without a
    // study, for another orientation, or for an unusable area.
    void showArea(const scene::SliceArea& area);
    void fit() { zoom_.fit(); }  // fits the volume, until a person zooms or pans
    // Applies one of scene::windowPresets; does nothing for a digit without one.
    void applyWindow(int digit) { windowing_.applyPreset(digit); }
    // The own windows; null: none. The list outlives it.
    void setOwnWindows(OwnWindowList* own) { windowing_.setOwn(own); }
    void applyOwnWindow(int number) { windowing_.applyOwn(number); }  // from 1; does nothing without it
    void editLabel(std::size_t index);                   // an index into the state's measurements, shown here
    void moveBy(int slices) { travel_.moveBy(slices); }  // along the normal: axial slices towards the head
    void setCine(bool on);  // steps back and forth, as one undo step; ends when hidden
    bool isCineOn() const { return cine_.isOn(); }

    // The frame of the picture on screen; nothing before the first.
    std::optional<slices::SliceFrame> shownFrame() const;
    QString positionText() const;    // see slice_texts.h
    QStringList tags() const;        // identify the volume beside another; without names
    QStringList notes() const;       // warnings: slab, inverted, interpolated
    QString probedText() const;      // the value under the pointer; empty outside the pane
    QString overProbedText() const;  // the same, of a second volume in colours
    // Whether the picture on screen shows the current state.
    bool isUpToDate() const { return picture_.isUpToDate(); }
    // The selected one of the state's measurements.
    std::optional<std::size_t> selected() const { return measurements_.selected(); }

    QSize sizeHint() const override { return {360, 360}; }
    QSize minimumSizeHint() const override { return {120, 120}; }

  Q_SIGNALS:
    void maximizeAsked();
    void savePictureAsked(const QImage& picture);  // the pane, as it is on screen
    void savePlanesAsked();                        // planes like the one that is shown
    void cineChanged(bool on);
    void pictureShown();
    void viewChanged(const macula::viewer::PaneView& view);  // by a person, or by fitting

  protected:
    bool event(QEvent* event) override;
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
    void listen();
    void showLines();    // those that identify what the pane shows
    void askForWords();  // of an arrow that was just drawn
    void onStudyShown();
    void onChanged(const scene::StudyState& before);
    void onPicture();
    void request();
    void endGesture();
    glm::ivec2 sizePx() const { return {width(), height()}; }

    StudyEditor& session_;
    PaneContent content_;
    PaneZoom zoom_;
    PanePicture picture_;
    std::shared_ptr<const slices::ShownSegments> segments_;

    SliceTravel travel_;
    SliceWindowing windowing_;
    PaneMeasurements measurements_;
    PaneClip clip_;
    PaneTurn turn_;
    PaneCurve curve_;
    SliceCine cine_;
    SliceHand hand_;
    SlicePopups popups_;
    SliceKeys keys_;
    SlicePainting painting_;
    std::optional<QPointF> hoverAt_;  // the pointer, while it is in the pane
};

}  // namespace macula::viewer
