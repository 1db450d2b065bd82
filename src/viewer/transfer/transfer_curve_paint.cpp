#include <QFontMetrics>
#include <QImage>
#include <QLineF>
#include <QLocale>
#include <QPaintEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <algorithm>
#include <array>
#include <cmath>

#include "viewer/transfer/encoded_colour.h"
#include "viewer/transfer/transfer_curve.h"

namespace macula::viewer {

namespace {

constexpr double kHandlePx = 4.0;  // radius; the selected one is larger
constexpr double kSelectedHandlePx = 6.0;
constexpr double kTickPx = 4.0;
constexpr float kHistogramAlpha = 0.25F;

QString numberText(double value, double step) {
    // Zero that was rounded reads -1e-17.
    return QLocale().toString(std::abs(value) < 1e-6 * step ? 0.0 : value, 'g', 7);
}

}  // namespace

void TransferCurve::paintEvent(QPaintEvent*) {
    if (background_.isNull() || background_.devicePixelRatio() != devicePixelRatioF())
        background_ = paintedBackground();
    QPainter painter(this);
    painter.drawPixmap(0, 0, background_);
    painter.setRenderHint(QPainter::Antialiasing);
    if (hasFunction()) {
        paintStrip(painter);
        paintCurve(painter);
        paintPoints(painter);
    }
    if (!hasFocus()) return;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

QPixmap TransferCurve::paintedBackground() const {
    const double ratio = devicePixelRatioF();
    QPixmap pixmap((QSizeF(size()) * ratio).toSize().expandedTo(QSize(1, 1)));
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(palette().color(QPalette::Window));
    QPainter painter(&pixmap);
    painter.setFont(font());
    painter.fillRect(plotRect(), palette().color(QPalette::Base));
    if (histogram_) paintHistogram(painter);
    if (hasFunction()) paintScales(painter);
    return pixmap;
}

void TransferCurve::paintHistogram(QPainter& painter) const {
    const QRectF plot = plotRect();
    const auto columns = std::size_t(std::max(1.0, plot.width()));
    const std::vector<double> heights = scene::logHeights(*histogram_, axis_.shown, columns);
    QPainterPath path(plot.bottomLeft());
    const double columnPx = plot.width() / double(columns);
    for (std::size_t i = 0; i < columns; ++i) {
        const double top = plot.bottom() - heights[i] * plot.height();
        path.lineTo(plot.left() + columnPx * double(i), top);
        path.lineTo(plot.left() + columnPx * double(i + 1), top);
    }
    path.lineTo(plot.bottomRight());
    QColor fill = palette().color(QPalette::Text);
    fill.setAlphaF(kHistogramAlpha);
    painter.fillPath(path, fill);
}

void TransferCurve::paintScales(QPainter& painter) const {
    const QRectF plot = plotRect();
    const QRectF axis = axisRect();
    const QColor ink = palette().color(QPalette::Text);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
    painter.drawRect(plot);
    painter.drawLine(QPointF(plot.left(), plot.center().y()), QPointF(plot.right(), plot.center().y()));
    painter.setPen(ink);
    for (const double opacity : {0.0, 0.5, 1.0}) {
        const double y = plot.bottom() - opacity * plot.height();
        const double half = 0.5 * fontMetrics().height();
        const double top = std::clamp(y - half, 0.0, plot.bottom() - half);
        painter.drawText(QRectF(0.0, top, plot.left() - kTickPx, 2.0 * half),
                         Qt::AlignRight | Qt::AlignVCenter, QLocale().toString(opacity, 'g', 2));
    }
    const double unitPx = unit_.isEmpty() ? 0.0 : fontMetrics().horizontalAdvance(unit_) + 2.0 * kTickPx;
    const QRectF unitRect(axis.right() - unitPx, axis.top(), unitPx, axis.height());
    painter.drawText(unitRect, Qt::AlignRight | Qt::AlignBottom, unit_);
    const double step = axis_.tickStep(kTicksApartPx);
    for (const double value : axis_.ticks(kTicksApartPx)) {
        const double x = plot.left() + axis_.pxOf(value);
        painter.drawLine(QPointF(x, axis.top()), QPointF(x, axis.top() + kTickPx));
        const QString text = numberText(value, step);
        const double half = 0.5 * fontMetrics().horizontalAdvance(text);
        // A number that would run into the unit or out of the picture is left out; its tick stays.
        if (x - half < 0.0 || x + half > unitRect.left()) continue;
        painter.drawText(QRectF(x - half, axis.top() + kTickPx, 2.0 * half + 1.0, axis.height() - kTickPx),
                         Qt::AlignLeft | Qt::AlignBottom, text);
    }
}

void TransferCurve::paintStrip(QPainter& painter) const {
    const QRectF strip = stripRect();
    const int columns = std::max(1, int(std::ceil(strip.width() * devicePixelRatioF())));
    QImage image(columns, 1, QImage::Format_RGB32);
    for (int i = 0; i < columns; ++i) {
        const double px = strip.left() + strip.width() * (i + 0.5) / columns;
        image.setPixel(i, 0, colourOf(colourAt(function_, presetValueAt(px))).rgb());
    }
    painter.drawImage(strip, image);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(strip);
}

void TransferCurve::paintCurve(QPainter& painter) const {
    const QRectF plot = plotRect();
    const auto place = [&](double px, double opacity) {
        return QPointF(px, plot.bottom() - opacity * plot.height());
    };
    // Each pixel, and each point besides: a peak may be narrower than a pixel.
    QPolygonF line;
    std::size_t next = 0;
    for (int column = 0; column <= int(plot.width()); ++column) {
        const double px = plot.left() + column;
        const double value = presetValueAt(px);
        for (; next < function_.opacity.size() && function_.opacity[next].value <= value; ++next) {
            const double at = plot.left() + axis_.pxOf(map_.shownFrom(function_.opacity[next].value));
            if (at >= plot.left()) line << place(at, function_.opacity[next].opacity);
        }
        line << place(px, opacityAt(function_, value));
    }
    painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
}

void TransferCurve::paintPoints(QPainter& painter) const {
    const QColor ink = palette().color(QPalette::Text);
    const QColor chosen = palette().color(QPalette::Highlight);
    QPointF last(-1.0, -1.0);
    const auto paint = [&](const PointId& point, const QColor& fill) {
        const QPointF at = placeOf(point);
        const bool isChosen = selected_ == point;
        const bool isCovered = !isChosen && QLineF(last, at).length() < 1.0;  // tables have hundreds
        if (isCovered || !QRectF(rect()).contains(at)) return;
        last = at;
        const double radius = isChosen ? kSelectedHandlePx : kHandlePx;
        painter.setPen(QPen(isChosen ? chosen : ink, isChosen ? 2.0 : 1.0));
        painter.setBrush(fill);
        painter.drawEllipse(at, radius, radius);
    };
    const QColor paper = palette().color(QPalette::Base);
    for (std::size_t i = 0; i < function_.opacity.size(); ++i) paint({PointId::Curve::opacity, i}, paper);
    for (std::size_t i = 0; i < function_.colour.size(); ++i)
        paint({PointId::Curve::colour, i}, colourOf(function_.colour[i].colour));
    // What is selected is seen, whatever lies over it.
    if (!selected_) return;
    const bool isColour = selected_->curve == PointId::Curve::colour;
    paint(*selected_, isColour ? colourOf(function_.colour[selected_->index].colour) : paper);
}

}  // namespace macula::viewer
