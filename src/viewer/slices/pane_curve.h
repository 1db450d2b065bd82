// Sets, moves and removes the points of a curve on a pane of slices, and draws the spline through them.
#pragma once

#include <QCoreApplication>
#include <QPainter>
#include <QPointF>
#include <cstddef>
#include <optional>
#include <vector>

#include "viewer/editor/study_editor.h"
#include "viewer/slices/kept_curve.h"
#include "viewer/slices/pane_content.h"
#include "viewer/slices/slice_sampler.h"

namespace macula::viewer {

// Proposes changes of the state's curve. `shown` is the request of the picture on screen; places are logical
// pixels of the pane.
class PaneCurve {
    Q_DECLARE_TR_FUNCTIONS(PaneCurve)

  public:
    PaneCurve(StudyEditor& session, const PaneContent& content);  // both outlive this

    bool hasPointAt(const QPointF& place, const SliceRequest& shown) const;
    // Holds the point there. Without one sets a new point: between two others if the curve passes there,
    // otherwise at its end.
    void hold(const QPointF& place, const SliceRequest& shown);
    void dragTo(const QPointF& place, const SliceRequest& shown);  // moves it in the plane
    void letGo() { isHeld_ = false; }
    void setPoint(const glm::dvec3& mm);  // at the end of the curve
    // The point that was held last in this pane, if the curve is still that one; else the end of the curve.
    // False without a point.
    bool removeLast();

    // Faint where the curve is away from the plane.
    void paint(QPainter& painter, const SliceRequest& shown);

  private:
    std::optional<std::size_t> pointAt(const QPointF& place, const SliceRequest& shown) const;
    std::size_t placeInOrder(const QPointF& place, const SliceRequest& shown);
    const slices::Curve& curve();
    void remember(std::optional<std::size_t> point);
    double nearMm() const;  // a point closer to the plane lies in it

    StudyEditor& session_;
    const PaneContent& content_;
    std::optional<std::size_t> last_;  // held last
    std::vector<glm::dvec3> lastOf_;   // the points when it was
    bool isHeld_ = false;
    KeptCurve curve_;
};

}  // namespace macula::viewer
