#include "viewer/dose/dvh_chart.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "viewer/language/harmless_text.h"
#include "viewer/slices/dose_over.h"

namespace macula::viewer {

namespace {

constexpr double kMarginPx = 8.0;
constexpr double kTickPx = 4.0;
constexpr double kPercent = 100.0;
constexpr double kNearPx = 14.0;
constexpr double kPxPerTick = 70.0;
constexpr double kCurvePx = 1.6;
constexpr double kMarkedPx = 3.2;
constexpr double kStepPx = 1.0;  // between points of a curve
constexpr double kBeyond = 1.05;

// 1, 2 or 5 times a power of ten, so that about `count` steps fill the range.
double stepFor(double range, double count) {
    const double raw = range / std::max(count, 1.0);
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double times : {1.0, 2.0, 5.0})
        if (raw <= times * power) return times * power;
    return 10.0 * power;
}

QString numberText(double value, int decimals) {
    return QLocale().toString(value, 'f', decimals);
}

}  // namespace

DvhChart::DvhChart(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setObjectName(QStringLiteral("dvh-chart"));
    setAccessibleName(tr("Dose-volume histogram"));
    setToolTip(tr("How much of each region receives at least a dose"));
}

void DvhChart::setReport(std::shared_ptr<const study::DoseReport> report) {
    report_ = std::move(report);
    hidden_.clear();
    marked_.reset();
    reading_.reset();
    update();
}

void DvhChart::setHidden(std::set<std::size_t> regions) {
    hidden_ = std::move(regions);
    update();
}

void DvhChart::setMarked(std::optional<std::size_t> region) {
    marked_ = region;
    update();
}

bool DvhChart::isShown(std::size_t region) const {
    return report_ && region < report_->regions.size() && hidden_.find(region) == hidden_.end() &&
           !report_->regions[region].dose.histogram.isEmpty();
}

QRectF DvhChart::plot() const {
    const QFontMetricsF metrics(font());
    const double left = kMarginPx + metrics.horizontalAdvance(QStringLiteral("100 %")) + 2.0 * kTickPx;
    const double below = kMarginPx + 2.0 * metrics.height() + kTickPx;
    return {left, kMarginPx, std::max(width() - left - 2.0 * kMarginPx, 1.0),
            std::max(height() - kMarginPx - below, 1.0)};
}

double DvhChart::mostDose() const {
    double most = 0.0;
    for (std::size_t i = 0; report_ && i < report_->regions.size(); ++i)
        if (isShown(i)) most = std::max(most, report_->regions[i].dose.histogram.maximum());
    if (report_ && report_->reference) most = std::max(most, report_->reference->value);
    return most > 0.0 ? kBeyond * most : 1.0;
}

double DvhChart::doseAt(double x) const {
    return (x - plot().left()) / plot().width() * mostDose();
}

QPointF DvhChart::placeOf(double dose, double share) const {
    const QRectF area = plot();
    return {area.left() + dose / mostDose() * area.width(), area.bottom() - share * area.height()};
}

std::optional<QPointF> DvhChart::placeOnCurve(std::size_t region, double dose) const {
    if (!isShown(region)) return std::nullopt;
    return placeOf(dose, report_->regions[region].dose.histogram.shareAt(dose));
}

std::optional<DvhChart::Reading> DvhChart::readingAt(const QPointF& place) const {
    const QRectF area = plot();
    if (!report_ || !area.contains(place)) return std::nullopt;
    std::optional<Reading> nearest;
    double distance = kNearPx;
    // Curves are steep: points a little to both sides may be nearer than the one straight above.
    for (double off = -kNearPx; off <= kNearPx; off += 1.0) {
        const double dose = std::max(doseAt(place.x() + off), 0.0);
        for (std::size_t i = 0; i < report_->regions.size(); ++i) {
            if (!isShown(i)) continue;
            const double share = report_->regions[i].dose.histogram.shareAt(dose);
            const double away = QLineF(placeOf(dose, share), place).length();
            if (away >= distance) continue;
            distance = away;
            nearest = Reading{.region = i, .dose = dose, .share = share};
        }
    }
    return nearest;
}

QString DvhChart::readText() const {
    if (!reading_ || !isShown(reading_->region)) return {};
    const QString unit = harmless(QString::fromStdString(report_->unit));
    return tr("%1: %2 % receive %3 %4 or more")
        .arg(harmless(QString::fromStdString(report_->regions[reading_->region].label)),
             numberText(kPercent * reading_->share, 1), numberText(reading_->dose, 2), unit);
}

void DvhChart::mouseMoveEvent(QMouseEvent* event) {
    const auto before = reading_ ? std::optional(reading_->region) : std::nullopt;
    reading_ = readingAt(event->position());
    const auto now = reading_ ? std::optional(reading_->region) : std::nullopt;
    update();
    if (now != before) Q_EMIT pointedAt(now);
}

void DvhChart::leaveEvent(QEvent*) {
    reading_.reset();
    update();
    Q_EMIT pointedAt(std::nullopt);
}

void DvhChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    if (!report_) return;
    paintAxes(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    paintReference(painter);
    paintCurves(painter);
    paintReading(painter);
}

void DvhChart::paintAxes(QPainter& painter) const {
    const QRectF area = plot();
    const QFontMetricsF metrics(font());
    const QColor ink = palette().color(QPalette::Text);
    QColor grid = ink;
    grid.setAlphaF(0.18F);
    const auto centred = [&](const QString& text, double x, double top) {
        painter.drawText(QPointF(x - 0.5 * metrics.horizontalAdvance(text), top + metrics.ascent()), text);
    };
    constexpr int kLines = 5;
    for (int i = 0; i <= kLines; ++i) {
        const double share = double(i) / kLines;
        const double y = placeOf(0.0, share).y();
        painter.setPen(grid);
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(ink);
        const QString text = tr("%1 %").arg(numberText(kPercent * share, 0));
        painter.drawText(QPointF(area.left() - 2.0 * kTickPx - metrics.horizontalAdvance(text),
                                 y + 0.5 * metrics.ascent() - 1.0),
                         text);
    }
    const double most = mostDose();
    const double step = stepFor(most, area.width() / kPxPerTick);
    const int decimals = std::clamp(int(-std::floor(std::log10(step))), 0, 6);
    for (int i = 0; i * step <= most; ++i) {
        const double x = placeOf(i * step, 0.0).x();
        painter.setPen(grid);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.setPen(ink);
        centred(numberText(i * step, decimals), x, area.bottom() + kTickPx);
    }
    const QString unit = harmless(QString::fromStdString(report_->unit));
    centred(tr("Dose (%1); upwards: share of the region that receives at least this dose").arg(unit),
            area.center().x(), area.bottom() + kTickPx + metrics.height());
}

void DvhChart::paintReference(QPainter& painter) const {
    if (!report_->reference) return;
    const QRectF area = plot();
    const double x = placeOf(report_->reference->value, 0.0).x();
    const QColor ink = palette().color(QPalette::PlaceholderText);
    painter.setPen(QPen(ink, 1.0, Qt::DashLine));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    const QString text = referenceText(*report_->reference, harmless(QString::fromStdString(report_->unit)));
    const QFontMetricsF metrics(font());
    painter.drawText(QPointF(x - kTickPx - metrics.horizontalAdvance(text), area.top() + metrics.ascent()),
                     text);
}

void DvhChart::paintCurves(QPainter& painter) const {
    const QRectF area = plot();
    const double most = mostDose();
    for (std::size_t i = 0; i < report_->regions.size(); ++i) {
        if (!isShown(i)) continue;
        const study::RegionInDose& region = report_->regions[i];
        const study::DoseHistogram& histogram = region.dose.histogram;
        QPainterPath path(placeOf(0.0, 1.0));
        for (double px = kStepPx; px <= area.width(); px += kStepPx) {
            const double dose = px / area.width() * most;
            path.lineTo(placeOf(dose, histogram.shareAt(dose)));
        }
        const bool isMarked = marked_ == i || (reading_ && reading_->region == i);
        painter.setPen(QPen(QColor(region.rgb[0], region.rgb[1], region.rgb[2]),
                            isMarked ? kMarkedPx : kCurvePx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPath(path);
    }
}

void DvhChart::paintReading(QPainter& painter) const {
    const QString text = readText();
    if (text.isEmpty()) return;
    const QRectF area = plot();
    const QPointF at = placeOf(reading_->dose, reading_->share);
    painter.setPen(QPen(palette().color(QPalette::Text), 1.0));
    painter.setBrush(palette().color(QPalette::Text));
    painter.drawEllipse(at, 3.0, 3.0);
    painter.setBrush(Qt::NoBrush);
    const QFontMetricsF metrics(font());
    QRectF box(0.0, 0.0, metrics.horizontalAdvance(text) + 2.0 * kTickPx, metrics.height() + kTickPx);
    box.moveTopLeft(at + QPointF(kMarginPx, -kMarginPx - box.height()));
    box.moveLeft(std::clamp(box.left(), area.left(), std::max(area.right() - box.width(), area.left())));
    box.moveTop(std::clamp(box.top(), area.top(), std::max(area.bottom() - box.height(), area.top())));
    painter.fillRect(box, palette().color(QPalette::ToolTipBase));
    painter.setPen(palette().color(QPalette::ToolTipText));
    painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace macula::viewer
