#include "viewer/transfer/transfer_curve.h"

#include <QEvent>
#include <QFontMetrics>
#include <QLocale>
#include <algorithm>
#include <utility>

namespace macula::viewer {

namespace {

// Logical pixels.
constexpr double kTopPx = 8.0;
constexpr double kRightPx = 10.0;
constexpr double kStripPx = 18.0;
constexpr double kGapPx = 8.0;  // between plot and strip

constexpr double kKeysPerTick = 50.0;
constexpr double kRare = 0.001;  // of the values, at either end of the axis

}  // namespace

TransferCurve::TransferCurve(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("transfer-curve"));
    setFocusPolicy(Qt::StrongFocus);
    setContextMenuPolicy(Qt::PreventContextMenu);  // the right button drags
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Transfer function: opacity and colour over value"));
    describe();
}

void TransferCurve::setFunction(TransferFunction function, const scene::ValueMap& map, const QString& unit) {
    const bool hadScales = hasFunction();
    function_ = std::move(function);
    map_ = map;
    if (unit != unit_ || !hadScales) invalidate();
    unit_ = unit;
    const auto sizeOf = [&](PointId::Curve curve) {
        return curve == PointId::Curve::opacity ? function_.opacity.size() : function_.colour.size();
    };
    if (selected_ && selected_->index >= sizeOf(selected_->curve)) select(std::nullopt);
    describe();
    update();
}

void TransferCurve::clear() {
    cancelDrag();
    select(std::nullopt);
    setFunction({}, {}, {});
    setHistogram(std::nullopt);
}

void TransferCurve::setHistogram(std::optional<scene::Histogram> histogram) {
    histogram_ = std::move(histogram);
    invalidate();
}

void TransferCurve::fitAxis() {
    if (!hasFunction()) return;
    ValueRange range{
        map_.shownFrom(std::min(function_.opacity.front().value, function_.colour.front().value)),
        map_.shownFrom(std::max(function_.opacity.back().value, function_.colour.back().value))};
    if (histogram_) {
        range.low = std::min(range.low, scene::percentile(*histogram_, kRare));
        range.high = std::max(range.high, scene::percentile(*histogram_, 1.0 - kRare));
    }
    setAxis(scene::ValueAxis::over(range, plotRect().width()), true);
}

void TransferCurve::cancelDrag() {
    drag_.reset();
    isNudging_ = false;
}

void TransferCurve::select(std::optional<PointId> point) {
    if (point == selected_) return;
    selected_ = point;
    describe();
    update();
    emit selectionChanged();
}

QPointF TransferCurve::placeOf(const PointId& point) const {
    const double x = plotRect().left() + axis_.pxOf(valueOf(point));
    if (point.curve == PointId::Curve::colour) return {x, stripRect().center().y()};
    return {x, plotRect().bottom() - function_.opacity.at(point.index).opacity * plotRect().height()};
}

QRectF TransferCurve::plotRect() const {
    const double left = fontMetrics().horizontalAdvance(QStringLiteral("0.5")) + kGapPx;
    const double bottom = stripRect().top() - kGapPx;
    return {left, kTopPx, std::max(1.0, width() - left - kRightPx), std::max(1.0, bottom - kTopPx)};
}

QRectF TransferCurve::stripRect() const {
    const double left = fontMetrics().horizontalAdvance(QStringLiteral("0.5")) + kGapPx;
    return {left, axisRect().top() - kStripPx, std::max(1.0, width() - left - kRightPx), kStripPx};
}

QRectF TransferCurve::axisRect() const {
    const double high = fontMetrics().height() + kGapPx;
    return {0.0, height() - high, double(width()), high};
}

double TransferCurve::keyStep() const {
    return axis_.tickStep(kTicksApartPx) / kKeysPerTick;
}

QSize TransferCurve::sizeHint() const {
    return {380, 260};
}

QSize TransferCurve::minimumSizeHint() const {
    return {200, 140};
}

void TransferCurve::resizeEvent(QResizeEvent*) {
    axis_.lengthPx = plotRect().width();
    invalidate();
}

void TransferCurve::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) axis_.lengthPx = plotRect().width();
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange ||
        event->type() == QEvent::EnabledChange || event->type() == QEvent::StyleChange)
        invalidate();
    QWidget::changeEvent(event);
}

double TransferCurve::presetValueAt(double px) const {
    return map_.presetFrom(axis_.valueAt(px - plotRect().left()));
}

double TransferCurve::opacityAtPx(double y) const {
    return std::clamp((plotRect().bottom() - y) / plotRect().height(), 0.0, 1.0);
}

double TransferCurve::valueOf(const PointId& point) const {
    return map_.shownFrom(point.curve == PointId::Curve::opacity ? function_.opacity.at(point.index).value
                                                                 : function_.colour.at(point.index).value);
}

void TransferCurve::setAxis(const scene::ValueAxis& axis, bool isFitted) {
    axis_ = axis;
    isAxisFitted_ = isFitted;
    invalidate();
}

void TransferCurve::reveal(const PointId& point) {
    const double value = valueOf(point);
    if (axis_.contains(value)) return;
    setAxis(axis_.panned(value - 0.5 * (axis_.shown.low + axis_.shown.high)), false);
}

void TransferCurve::propose(const TransferFunction& function, bool isDrag) {
    if (function == function_) return;
    if (isDrag) {
        emit dragged(function);
    } else {
        emit edited(function);
    }
}

// For who does not see the picture.
void TransferCurve::describe() {
    const QString unit = unit_.isEmpty() ? QString() : QStringLiteral(" ") + unit_;
    setToolTip(tr("Values%1 from left to right, opacity (0 to 1, of a layer %2 mm thick) upwards, with how "
                  "often each value is in the volume behind it; colours below.\n"
                  "Drag a point; double click adds one, Delete removes it; arrows move it, with Shift "
                  "finer.\n"
                  "Right drag, or Alt + left drag, beside the points: shift all, and widen upwards; with "
                  "Ctrl: more opaque upwards.\n"
                  "Wheel: zoom the axis; drag the axis to move it; double click on it shows all.")
                   .arg(unit.isEmpty() ? QString() : tr(" in %1").arg(unit_),
                        QLocale().toString(function_.unitDistanceMm, 'g', 4)));
    if (!selected_) {
        setAccessibleDescription(
            tr("%n points; none is selected. Arrows shift and widen all of them, Tab "
               "goes through them.",
               nullptr, pointCount()));
        return;
    }
    const bool isColour = selected_->curve == PointId::Curve::colour;
    const QString value = QLocale().toString(valueOf(*selected_), 'g', 7) + unit;
    if (isColour) {
        setAccessibleDescription(
            tr("Colour point %1 of %2 at %3")
                .arg(QString::number(selected_->index + 1), QString::number(function_.colour.size()), value));
    } else {
        setAccessibleDescription(
            tr("Opacity point %1 of %2 at %3, opacity %4")
                .arg(QString::number(selected_->index + 1), QString::number(function_.opacity.size()), value,
                     QLocale().toString(function_.opacity[selected_->index].opacity, 'g', 3)));
    }
}

void TransferCurve::invalidate() {
    background_ = QPixmap();
    update();
}

}  // namespace macula::viewer
