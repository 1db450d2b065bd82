// The plot of a transfer function: its points, its axis of values, where each is on screen, and its painting.
#pragma once

#include <QFont>
#include <QFontMetrics>
#include <QObject>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QPointF>
#include <QRectF>
#include <QSize>
#include <QString>
#include <cstddef>
#include <functional>
#include <optional>

#include "pipeline/volume/transfer_function.h"
#include "scene/transfer/histogram.h"
#include "scene/transfer/value_axis.h"

namespace macula::viewer {

// A point of a transfer function.
struct PointId {
    enum class Curve { opacity, colour };
    Curve curve = Curve::opacity;
    std::size_t index = 0;

    bool operator==(const PointId&) const = default;
};

// The areas of the plot in a widget, in logical pixels.
struct TransferLayout {
    QRectF plot;   // opacity 1 at its top, 0 at its bottom
    QRectF strip;  // colours
    QRectF axis;

    static TransferLayout of(const QSize& size, const QFontMetrics& metrics);
};

// The axis shows values of the volume; scene::ValueMap maps them to those of the function. Places are in the
// layout's pixels.
class TransferPlot : public QObject {
    Q_OBJECT

  public:
    static constexpr double kTicksApartPx = 80.0;  // least distance of ticks

    // `layout` returns the present one.
    explicit TransferPlot(std::function<TransferLayout()> layout);

    void setFunction(TransferFunction function, const scene::ValueMap& map, const QString& unit);
    void setHistogram(std::optional<scene::Histogram> histogram);
    const TransferFunction& function() const { return function_; }
    const scene::ValueMap& map() const { return map_; }
    const QString& unit() const { return unit_; }
    const std::optional<scene::Histogram>& histogram() const { return histogram_; }
    bool hasFunction() const { return !function_.opacity.empty() && !function_.colour.empty(); }

    std::size_t countOf(PointId::Curve curve) const;
    std::size_t pointCount() const { return function_.opacity.size() + function_.colour.size(); }
    double valueOf(const PointId& point) const;  // a value of the volume

    TransferLayout layout() const { return layout_(); }
    QPointF placeOf(const PointId& point) const;  // outside of the plot if the axis does not reach it
    // The nearest point within reach of a pointer; of several at one place, the last.
    std::optional<PointId> pointAt(const QPointF& at) const;
    double presetValueAt(double x) const;
    double opacityAt(double y) const;

    const scene::ValueAxis& axis() const { return axis_; }
    bool isAxisFitted() const { return isAxisFitted_; }  // not zoomed since fitAxis
    void fitAxis();                                      // shows all points, and all values that are not rare
    void setAxis(const scene::ValueAxis& axis);          // for a person's zoom or pan
    void reveal(const PointId& point);
    void takeLength();       // takes over the width of the changed layout
    double keyStep() const;  // units of the volume that an arrow key moves by

  Q_SIGNALS:
    void scalesChanged();  // axis, unit or histogram

  private:
    void show(const scene::ValueAxis& axis, bool isFitted);

    std::function<TransferLayout()> layout_;
    TransferFunction function_;
    scene::ValueMap map_;
    QString unit_;
    std::optional<scene::Histogram> histogram_;
    scene::ValueAxis axis_;
    bool isAxisFitted_ = true;
};

// Paints the plot. Histogram and scales are painted once, until forget() or another pixel ratio.
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
