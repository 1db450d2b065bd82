#include "viewer/transfer/transfer_plot.h"

#include <QImage>
#include <QLineF>
#include <QLocale>
#include <QPainterPath>
#include <QPolygonF>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "viewer/transfer/encoded_colour.h"

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

constexpr double kHandlePx = 4.0;  // radius; the selected one is larger
constexpr double kSelectedHandlePx = 6.0;
constexpr double kTickPx = 4.0;
constexpr float kHistogramAlpha = 0.25F;

QString numberText(double value, double step) {
    // Otherwise a rounded zero could read -1e-17.
    return QLocale().toString(std::abs(value) < 1e-6 * step ? 0.0 : value, 'g', 7);
}

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

void TransferPainting::paint(QPainter& painter, const Look& look, const std::optional<PointId>& selected) {
    if (background_.isNull() || background_.devicePixelRatio() != look.pixelRatio)
        background_ = paintedBackground(look);
    painter.drawPixmap(0, 0, background_);
    painter.setRenderHint(QPainter::Antialiasing);
    if (plot_.hasFunction()) {
        paintStrip(painter, look);
        paintCurve(painter, look);
        paintPoints(painter, look, selected);
    }
    if (!look.hasFocus) return;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(look.palette.color(QPalette::Highlight), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRect(QPoint(0, 0), look.size).adjusted(0, 0, -1, -1));
}

QPixmap TransferPainting::paintedBackground(const Look& look) const {
    const double ratio = look.pixelRatio;
    QPixmap pixmap((QSizeF(look.size) * ratio).toSize().expandedTo(QSize(1, 1)));
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(look.palette.color(QPalette::Window));
    QPainter painter(&pixmap);
    painter.setFont(look.font);
    painter.fillRect(plot_.layout().plot, look.palette.color(QPalette::Base));
    if (plot_.histogram()) paintHistogram(painter, look);
    if (plot_.hasFunction()) paintScales(painter, look);
    return pixmap;
}

void TransferPainting::paintHistogram(QPainter& painter, const Look& look) const {
    const QRectF plot = plot_.layout().plot;
    const auto columns = std::size_t(std::max(1.0, plot.width()));
    const std::vector<double> heights = scene::logHeights(*plot_.histogram(), plot_.axis().shown, columns);
    QPainterPath path(plot.bottomLeft());
    const double columnPx = plot.width() / double(columns);
    for (std::size_t i = 0; i < columns; ++i) {
        const double top = plot.bottom() - heights[i] * plot.height();
        path.lineTo(plot.left() + columnPx * double(i), top);
        path.lineTo(plot.left() + columnPx * double(i + 1), top);
    }
    path.lineTo(plot.bottomRight());
    QColor fill = look.palette.color(QPalette::Text);
    fill.setAlphaF(kHistogramAlpha);
    painter.fillPath(path, fill);
}

void TransferPainting::paintScales(QPainter& painter, const Look& look) const {
    const QRectF plot = plot_.layout().plot;
    const QRectF axis = plot_.layout().axis;
    const QColor ink = look.palette.color(QPalette::Text);
    painter.setPen(QPen(look.palette.color(QPalette::Mid), 1.0));
    painter.drawRect(plot);
    painter.drawLine(QPointF(plot.left(), plot.center().y()), QPointF(plot.right(), plot.center().y()));
    painter.setPen(ink);
    for (const double opacity : {0.0, 0.5, 1.0}) {
        const double y = plot.bottom() - opacity * plot.height();
        const double half = 0.5 * look.metrics.height();
        const double top = std::clamp(y - half, 0.0, plot.bottom() - half);
        painter.drawText(QRectF(0.0, top, plot.left() - kTickPx, 2.0 * half),
                         Qt::AlignRight | Qt::AlignVCenter, QLocale().toString(opacity, 'g', 2));
    }
    const double unitPx =
        plot_.unit().isEmpty() ? 0.0 : look.metrics.horizontalAdvance(plot_.unit()) + 2.0 * kTickPx;
    const QRectF unitRect(axis.right() - unitPx, axis.top(), unitPx, axis.height());
    painter.drawText(unitRect, Qt::AlignRight | Qt::AlignBottom, plot_.unit());
    const double step = plot_.axis().tickStep(TransferPlot::kTicksApartPx);
    for (const double value : plot_.axis().ticks(TransferPlot::kTicksApartPx)) {
        const double x = plot.left() + plot_.axis().pxOf(value);
        painter.drawLine(QPointF(x, axis.top()), QPointF(x, axis.top() + kTickPx));
        const QString text = numberText(value, step);
        const double half = 0.5 * look.metrics.horizontalAdvance(text);
        // Leaves out a number that would overlap the unit or leave the picture; its tick stays.
        if (x - half < 0.0 || x + half > unitRect.left()) continue;
        painter.drawText(QRectF(x - half, axis.top() + kTickPx, 2.0 * half + 1.0, axis.height() - kTickPx),
                         Qt::AlignLeft | Qt::AlignBottom, text);
    }
}

void TransferPainting::paintStrip(QPainter& painter, const Look& look) const {
    const QRectF strip = plot_.layout().strip;
    const int columns = std::max(1, int(std::ceil(strip.width() * look.pixelRatio)));
    QImage image(columns, 1, QImage::Format_RGB32);
    for (int i = 0; i < columns; ++i) {
        const double px = strip.left() + strip.width() * (i + 0.5) / columns;
        image.setPixel(i, 0, colourOf(colourAt(plot_.function(), plot_.presetValueAt(px))).rgb());
    }
    painter.drawImage(strip, image);
    painter.setPen(QPen(look.palette.color(QPalette::Mid), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(strip);
}

void TransferPainting::paintCurve(QPainter& painter, const Look& look) const {
    const QRectF plot = plot_.layout().plot;
    const auto place = [&](double px, double opacity) {
        return QPointF(px, plot.bottom() - opacity * plot.height());
    };
    // At each pixel, and at each point as well: a peak may be narrower than a pixel.
    QPolygonF line;
    std::size_t next = 0;
    for (int column = 0; column <= int(plot.width()); ++column) {
        const double px = plot.left() + column;
        const double value = plot_.presetValueAt(px);
        for (; next < plot_.function().opacity.size() && plot_.function().opacity[next].value <= value;
             ++next) {
            const double at =
                plot.left() + plot_.axis().pxOf(plot_.map().shownFrom(plot_.function().opacity[next].value));
            if (at >= plot.left()) line << place(at, plot_.function().opacity[next].opacity);
        }
        line << place(px, opacityAt(plot_.function(), value));
    }
    painter.setPen(QPen(look.palette.color(QPalette::Text), 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
}

void TransferPainting::paintPoints(QPainter& painter, const Look& look,
                                   const std::optional<PointId>& selected) const {
    const QColor ink = look.palette.color(QPalette::Text);
    const QColor chosen = look.palette.color(QPalette::Highlight);
    QPointF last(-1.0, -1.0);
    const auto paint = [&](const PointId& point, const QColor& fill) {
        const QPointF at = plot_.placeOf(point);
        const bool isChosen = selected == point;
        const bool isCovered = !isChosen && QLineF(last, at).length() < 1.0;  // as in large tables
        if (isCovered || !QRectF(QRect(QPoint(0, 0), look.size)).contains(at)) return;
        last = at;
        const double radius = isChosen ? kSelectedHandlePx : kHandlePx;
        painter.setPen(QPen(isChosen ? chosen : ink, isChosen ? 2.0 : 1.0));
        painter.setBrush(fill);
        painter.drawEllipse(at, radius, radius);
    };
    const QColor paper = look.palette.color(QPalette::Base);
    for (std::size_t i = 0; i < plot_.function().opacity.size(); ++i)
        paint({PointId::Curve::opacity, i}, paper);
    for (std::size_t i = 0; i < plot_.function().colour.size(); ++i)
        paint({PointId::Curve::colour, i}, colourOf(plot_.function().colour[i].colour));
    // Paints the selected point last, above all others.
    if (!selected) return;
    const bool isColour = selected->curve == PointId::Curve::colour;
    paint(*selected, isColour ? colourOf(plot_.function().colour[selected->index].colour) : paper);
}

}  // namespace macula::viewer
