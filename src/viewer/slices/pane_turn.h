// Turns the planes of slices: rings on the lines of a pane's cross-hair, which a person drags around it.
#pragma once

#include <QCoreApplication>
#include <QPainter>
#include <QPointF>
#include <QSize>
#include <QString>
#include <optional>
#include <vector>

#include "viewer/editor/study_editor.h"
#include "viewer/overlay/slice_overlay.h"
#include "viewer/slices/pane_content.h"
#include "viewer/slices/slice_sampler.h"

namespace macula::viewer {

// Turns the planes of the two other panes about this pane's normal, through the cross-hair; the three stay
// perpendicular, and the picture of this pane stays as it is. `shown` is the request of the picture on
// screen; places are logical pixels of the pane.
class PaneTurn {
    Q_DECLARE_TR_FUNCTIONS(PaneTurn)

  public:
    PaneTurn(StudyEditor& session, const PaneContent& content);  // both outlive this

    // The lines of the other two planes in that picture.
    CrosshairLines linesOn(const slices::SlicePlane& plane) const;
    bool hasRingAt(const QPointF& place, const SliceRequest& shown) const;
    void hold(const QPointF& place, const SliceRequest& shown);
    void letGo() { held_.reset(); }
    // The lines follow the pointer. They catch on the pane's axes, and with `inSteps` every 15 degrees.
    void dragTo(const QPointF& place, const SliceRequest& shown, bool inSteps);

    void turnBy(double deg, const slices::SlicePlane& plane);  // clockwise in a picture of that plane
    // How far the pane's lines are turned, "12.5°", while one is held or pointed at; otherwise empty.
    QString angleText(const SliceRequest& shown, const std::optional<QPointF>& pointedAt) const;
    // Rings, if the pointer is in the pane.
    void paint(QPainter& painter, const SliceRequest& shown, const std::optional<QPointF>& pointedAt) const;

  private:
    struct Ring {
        QPointF at;
        bool isVertical = false;  // on the vertical line
    };
    std::vector<Ring> ringsOn(const SliceRequest& shown) const;
    QPointF crosshairOn(const SliceRequest& shown) const;

    StudyEditor& session_;
    const PaneContent& content_;
    // The angle in the picture from the pane's axis to the held end of a line less that to the pointer.
    std::optional<double> held_;
};

}  // namespace macula::viewer
