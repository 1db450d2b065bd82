#include "viewer/slices/pane_curve.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "scene/state/slices_json.h"
#include "viewer/overlay/haloed_drawing.h"

namespace macula::viewer {

namespace {

constexpr double kReachPx = 9.0;
constexpr double kPointPx = 4.0;
constexpr double kEveryMm = 0.5;  // the curve is drawn by lines of this length
const QColor kInk(255, 130, 220);
const QColor kFaintInk(255, 130, 220, 110);

QPointF onPane(const glm::dvec3& mm, const SliceRequest& shown) {
    const glm::dvec2 px = shown.frame.pictureFromWorld(mm) / shown.pixelRatio;
    return {px.x, px.y};
}

double awayPx(const QPointF& a, const QPointF& b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

}  // namespace

PaneCurve::PaneCurve(StudyEditor& session, const PaneContent& content)
    : session_(session), content_(content) {}

double PaneCurve::nearMm() const {
    return std::max(std::abs(content_.steps().stepMm()), 1.0);
}

const slices::Curve& PaneCurve::curve() {
    return curve_.through(session_.state().slices.curveMm);
}

std::optional<std::size_t> PaneCurve::pointAt(const QPointF& place, const SliceRequest& shown) const {
    const auto& points = session_.state().slices.curveMm;
    std::optional<std::size_t> nearest;
    double leastPx = kReachPx;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double px = awayPx(onPane(points[i], shown), place);
        if (!(px <= leastPx) || !(std::abs(shown.frame.distanceMm(points[i])) <= nearMm())) continue;
        leastPx = px;
        nearest = i;
    }
    return nearest;
}

bool PaneCurve::hasPointAt(const QPointF& place, const SliceRequest& shown) const {
    return shown.showsStudy() && pointAt(place, shown).has_value();
}

std::size_t PaneCurve::placeInOrder(const QPointF& place, const SliceRequest& shown) {
    const auto& points = session_.state().slices.curveMm;
    if (!curve().isUsable()) return points.size();
    const glm::dvec3 mm = shown.worldFromPane(place);
    const double atMm = curve().nearestMm(mm);
    const glm::dvec3 on = curve().at(atMm).mm;
    const bool isBetween = atMm > 0.0 && atMm < curve().lengthMm() &&
                           std::abs(shown.frame.distanceMm(on)) <= nearMm() &&
                           awayPx(onPane(on, shown), place) <= kReachPx;
    if (!isBetween) return points.size();
    std::size_t before = 0;
    while (before < points.size() && curve().nearestMm(points[before]) < atMm) ++before;
    return before;
}

void PaneCurve::hold(const QPointF& place, const SliceRequest& shown) {
    remember(pointAt(place, shown));
    isHeld_ = true;
    session_.endDrag();
    if (last_) return;
    if (session_.state().slices.curveMm.size() >= scene::kMostCurvePoints) {
        isHeld_ = false;
        return;
    }
    const std::size_t at = placeInOrder(place, shown);
    session_.drag(tr("Curve"), [&](scene::StudyState& next) {
        auto& points = next.slices.curveMm;
        points.insert(points.begin() + std::ptrdiff_t(at), shown.worldFromPane(place));
    });
    remember(at);
}

void PaneCurve::remember(std::optional<std::size_t> point) {
    last_ = point;
    lastOf_ = session_.state().slices.curveMm;
}

void PaneCurve::dragTo(const QPointF& place, const SliceRequest& shown) {
    const auto& points = session_.state().slices.curveMm;
    if (!isHeld_ || !last_ || *last_ >= points.size()) return;
    session_.drag(tr("Curve"),
                  [&](scene::StudyState& next) { next.slices.curveMm[*last_] = shown.worldFromPane(place); });
    remember(last_);
}

void PaneCurve::setPoint(const glm::dvec3& mm) {
    const std::size_t count = session_.state().slices.curveMm.size();
    if (count >= scene::kMostCurvePoints) return;
    session_.change(tr("Curve"), [&](scene::StudyState& next) { next.slices.curveMm.push_back(mm); });
    remember(count);
}

bool PaneCurve::removeLast() {
    const std::size_t count = session_.state().slices.curveMm.size();
    if (count == 0) return false;
    const bool isKnown = last_ && *last_ < count && lastOf_ == session_.state().slices.curveMm;
    const std::size_t at = isKnown ? *last_ : count - 1;
    session_.change(tr("Curve"), [&](scene::StudyState& next) {
        next.slices.curveMm.erase(next.slices.curveMm.begin() + std::ptrdiff_t(at));
    });
    remember(at > 0 ? std::optional(at - 1) : std::nullopt);
    return true;
}

void PaneCurve::paint(QPainter& painter, const SliceRequest& shown) {
    const auto& points = session_.state().slices.curveMm;
    if (points.empty() || !shown.showsStudy()) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath here;
    QPainterPath away;
    if (curve().isUsable()) {
        const double length = curve().lengthMm();
        const int lines = int(std::clamp(std::ceil(length / kEveryMm), 1.0, 5000.0));
        for (int i = 0; i < lines; ++i) {
            const glm::dvec3 from = curve().at(length * i / lines).mm;
            QPainterPath& path = std::abs(shown.frame.distanceMm(from)) <= nearMm() ? here : away;
            if (path.elementCount() == 0 || path.currentPosition() != onPane(from, shown))
                path.moveTo(onPane(from, shown));
            path.lineTo(onPane(curve().at(length * (i + 1) / lines).mm, shown));
        }
    }
    painter.setPen(QPen(kFaintInk, 1.0));
    painter.drawPath(away);
    drawHaloed(painter, here, kInk, 1.5);
    for (const glm::dvec3& mm : points) {
        if (std::abs(shown.frame.distanceMm(mm)) > nearMm()) continue;
        QPainterPath point;
        point.addEllipse(onPane(mm, shown), kPointPx, kPointPx);
        drawHaloed(painter, point, kInk, 1.5);
    }
    painter.restore();
}

}  // namespace macula::viewer
