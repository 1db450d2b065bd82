// What opens over a pane of slices: its context menu, and the editor of a measurement's label.
#pragma once

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

// Both are of the picture on screen; without one, nothing opens. Lives on the UI thread.
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
    // Opens them over `pane`; that and the parts outlive this.
    SlicePopups(QWidget& pane, const Parts& parts) : pane_(pane), parts_(parts) {}

    // At a place in the pane, in logical pixels. Selects the measurement there, whose label it offers to
    // edit. None over the second volume, which has its own bar, nor while a measurement is drawn.
    void openMenu(const QPointF& place);
    void editLabel(std::size_t measurement);  // an index into the state's
    void closeLabel();                        // without keeping it

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;  // of the menu

  private:
    QWidget& pane_;
    Parts parts_;
};

}  // namespace macula::viewer
