// A chart of cumulative dose-volume histograms.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QString>
#include <QWidget>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>

#include "study/dose/dose_report.h"

namespace macula::viewer {

// Dose to the right from 0, the share of the volume that receives at least this dose upwards. The pointer
// reads the nearest curve.
class DvhChart : public QWidget {
    Q_OBJECT

  public:
    explicit DvhChart(QWidget* parent = nullptr);

    void setReport(std::shared_ptr<const study::DoseReport> report);  // null: none
    void setHidden(std::set<std::size_t> regions);                    // by index
    void setMarked(std::optional<std::size_t> region);                // its curve is thick

    // What stands beside the pointer: "PTV: 95.0 % receive 57.1 Gy or more". Empty without a curve there.
    QString readText() const;
    // Where that point of a region's curve lies; nothing for a region without a curve.
    std::optional<QPointF> placeOnCurve(std::size_t region, double dose) const;

    QSize sizeHint() const override { return {640, 320}; }
    QSize minimumSizeHint() const override { return {240, 160}; }

  Q_SIGNALS:
    void pointedAt(std::optional<std::size_t> region);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    struct Reading {
        std::size_t region = 0;
        double dose = 0.0;
        double share = 0.0;
    };
    bool isShown(std::size_t region) const;
    QRectF plot() const;
    double mostDose() const;  // at the right end
    double doseAt(double x) const;
    QPointF placeOf(double dose, double share) const;
    std::optional<Reading> readingAt(const QPointF& place) const;
    void paintAxes(QPainter& painter) const;
    void paintCurves(QPainter& painter) const;
    void paintReference(QPainter& painter) const;
    void paintReading(QPainter& painter) const;

    std::shared_ptr<const study::DoseReport> report_;
    std::set<std::size_t> hidden_;
    std::optional<std::size_t> marked_;
    std::optional<Reading> reading_;
};

}  // namespace macula::viewer
