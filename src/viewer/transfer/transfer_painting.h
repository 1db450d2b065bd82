// Paints a plotted transfer function.
#pragma once

#include <QFont>
#include <QFontMetrics>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QSize>
#include <optional>

#include "viewer/transfer/transfer_plot.h"

namespace macula::viewer {

// Histogram and scales are painted once, until forget() or another pixel ratio.
class TransferPainting {
  public:
    // How the widget looks.
    struct Look {
        QSize size;  // logical pixels
        double pixelRatio = 1.0;
        QPalette palette;
        QFont font;
        QFontMetrics metrics;
        bool hasFocus = false;
    };

    explicit TransferPainting(const TransferPlot& plot) : plot_(plot) {}  // outlives this

    void forget() { background_ = QPixmap(); }
    void paint(QPainter& painter, const Look& look, const std::optional<PointId>& selected);

  private:
    QPixmap paintedBackground(const Look& look) const;
    void paintHistogram(QPainter& painter, const Look& look) const;
    void paintScales(QPainter& painter, const Look& look) const;
    void paintStrip(QPainter& painter, const Look& look) const;
    void paintCurve(QPainter& painter, const Look& look) const;
    void paintPoints(QPainter& painter, const Look& look, const std::optional<PointId>& selected) const;

    const TransferPlot& plot_;
    QPixmap background_;  // histogram and scales; null: to be painted
};

}  // namespace macula::viewer
