// The popups of a pane of slices: its context menu, and the editor of a measurement's label.
#pragma once

#include <QImage>
#include <QLineEdit>
#include <QObject>
#include <QPointF>
#include <cstddef>

#include "viewer/editor/study_editor.h"
#include "viewer/slices/pane_content.h"
#include "viewer/slices/pane_measurements.h"
#include "viewer/slices/pane_picture.h"
#include "viewer/slices/pane_zoom.h"
#include "viewer/slices/slice_hand.h"
#include "viewer/slices/slice_windowing.h"

class QWidget;

namespace macula::viewer {

// A line edit that deletes itself: Enter or loss of focus accepts the text, Esc keeps the old one. Cuts the
// text to scene::kLongestLabelBytes of UTF-8.
class LabelEditor : public QLineEdit {
    Q_OBJECT

  public:
    // Within `pane`, as near to `place` as it fits; takes the keyboard focus.
    LabelEditor(QWidget* pane, QPoint place, const QString& text);

  Q_SIGNALS:
    void accepted(const QString& text);  // at most once; differs from the old text

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    void finish(bool isAccepted);

    QString before_;
    bool isDone_ = false;
};

// Both refer to the picture on screen; without one, nothing opens. Lives on the UI thread.
class SlicePopups : public QObject {
    Q_OBJECT

  public:
    struct Parts {
        StudyEditor& session;
        const PaneContent& content;
        const PanePicture& picture;
        PaneZoom& zoom;
        SliceWindowing& windowing;
        PaneMeasurements& measurements;
        SliceHand& hand;
    };
    // Opens both over `pane`. `pane` and the parts outlive this.
    SlicePopups(QWidget& pane, const Parts& parts) : pane_(pane), parts_(parts) {}

    // Opens at a place in the pane, in logical pixels. Selects the measurement there, and offers to edit its
    // label. Opens no menu over the second volume, which has its own bar, or while a measurement is drawn.
    void openMenu(const QPointF& place);
    void editLabel(std::size_t measurement);  // an index into the state's measurements
    void closeLabel();                        // drops the edited text
    void copyPicture();                       // the pane to the clipboard

  Q_SIGNALS:
    void savePictureAsked(const QImage& picture);  // the pane, as it is on screen
    void savePlanesAsked();                        // planes like the one that is shown

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;  // watches the menu

  private:
    QWidget& pane_;
    Parts parts_;
};

}  // namespace macula::viewer
