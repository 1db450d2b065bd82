#include "viewer/transfer/transfer_plot.h"

#include <QLineF>
#include <algorithm>
#include <utility>

namespace macula::viewer {

namespace {

// Logical pixels.
constexpr double kTopPx = 8.0;
constexpr double kRightPx = 10.0;
constexpr double kStripPx = 18.0;
constexpr double kGapPx = 8.0;  // between plot and strip
constexpr double kHitPx = 8.0;

constexpr double kKeysPerTick = 50.0;
constexpr double kRare = 0.001;  // share of the values at either end that the axis leaves out

}  // namespace

TransferLayout TransferLayout::of(const QSize& size, const QFontMetrics& metrics) {
    const double left = metrics.horizontalAdvance(QStringLiteral("0.5")) + kGapPx;
    const double wide = std::max(1.0, size.width() - left - kRightPx);
    const double axisHigh = metrics.height() + kGapPx;
    const QRectF axis(0.0, size.height() - axisHigh, double(size.width()), axisHigh);
    const QRectF strip(left, axis.top() - kStripPx, wide, kStripPx);
    const double bottom = strip.top() - kGapPx;
    return {.plot = {left, kTopPx, wide, std::max(1.0, bottom - kTopPx)}, .strip = strip, .axis = axis};
}

TransferPlot::TransferPlot(std::function<TransferLayout()> layout) : layout_(std::move(layout)) {}

void TransferPlot::setFunction(TransferFunction function, const scene::ValueMap& map, const QString& unit) {
    const bool isNewScale = unit != unit_ || !hasFunction();
    function_ = std::move(function);
    map_ = map;
    unit_ = unit;
    if (isNewScale) Q_EMIT scalesChanged();
}

void TransferPlot::setHistogram(std::optional<scene::Histogram> histogram) {
    histogram_ = std::move(histogram);
    Q_EMIT scalesChanged();
}

std::size_t TransferPlot::countOf(PointId::Curve curve) const {
    return curve == PointId::Curve::opacity ? function_.opacity.size() : function_.colour.size();
}

double TransferPlot::valueOf(const PointId& point) const {
    return map_.shownFrom(point.curve == PointId::Curve::opacity ? function_.opacity.at(point.index).value
                                                                 : function_.colour.at(point.index).value);
}

QPointF TransferPlot::placeOf(const PointId& point) const {
    const TransferLayout now = layout();
    const double x = now.plot.left() + axis_.pxOf(valueOf(point));
    if (point.curve == PointId::Curve::colour) return {x, now.strip.center().y()};
    return {x, now.plot.bottom() - function_.opacity.at(point.index).opacity * now.plot.height()};
}

// Of several points at one place the last, because it can be pulled off to the right.
std::optional<PointId> TransferPlot::pointAt(const QPointF& at) const {
    std::optional<PointId> nearest;
    double distance = kHitPx;
    const auto look = [&](const PointId& point) {
        const double away = QLineF(placeOf(point), at).length();
        if (away > distance) return;
        distance = away;
        nearest = point;
    };
    for (std::size_t i = 0; i < function_.opacity.size(); ++i) look({PointId::Curve::opacity, i});
    for (std::size_t i = 0; i < function_.colour.size(); ++i) look({PointId::Curve::colour, i});
    return nearest;
}

double TransferPlot::presetValueAt(double x) const {
    return map_.presetFrom(axis_.valueAt(x - layout().plot.left()));
}

double TransferPlot::opacityAt(double y) const {
    const QRectF plot = layout().plot;
    return std::clamp((plot.bottom() - y) / plot.height(), 0.0, 1.0);
}

void TransferPlot::fitAxis() {
    if (!hasFunction()) return;
    ValueRange range{
        map_.shownFrom(std::min(function_.opacity.front().value, function_.colour.front().value)),
        map_.shownFrom(std::max(function_.opacity.back().value, function_.colour.back().value))};
    if (histogram_) {
        range.low = std::min(range.low, scene::percentile(*histogram_, kRare));
        range.high = std::max(range.high, scene::percentile(*histogram_, 1.0 - kRare));
    }
    show(scene::ValueAxis::over(range, layout().plot.width()), true);
}

void TransferPlot::setAxis(const scene::ValueAxis& axis) {
    show(axis, false);
}

void TransferPlot::show(const scene::ValueAxis& axis, bool isFitted) {
    axis_ = axis;
    isAxisFitted_ = isFitted;
    Q_EMIT scalesChanged();
}

void TransferPlot::reveal(const PointId& point) {
    const double value = valueOf(point);
    if (axis_.contains(value)) return;
    setAxis(axis_.panned(value - 0.5 * (axis_.shown.low + axis_.shown.high)));
}

void TransferPlot::takeLength() {
    axis_.lengthPx = layout().plot.width();
    Q_EMIT scalesChanged();
}

double TransferPlot::keyStep() const {
    return axis_.tickStep(kTicksApartPx) / kKeysPerTick;
}

}  // namespace macula::viewer
