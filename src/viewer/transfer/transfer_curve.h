// An editable plot of a transfer function: opacity over a histogram, colours, and the axis of values below.
// Mouse, keys and painting have files of their own.
#pragma once

#include <QPixmap>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <QWidget>
#include <optional>

#include "pipeline/volume/transfer_function.h"
#include "scene/transfer/histogram.h"
#include "scene/transfer/value_axis.h"
#include "viewer/transfer/point_id.h"

namespace macula::viewer {

// Shows a function but does not change it: an edit emits the wanted function, and the listener may return it
// by setFunction. Shown values are the volume's; the function has its own (scene::ValueMap). Empty without a
// function.
class TransferCurve : public QWidget {
    Q_OBJECT

  public:
    explicit TransferCurve(QWidget* parent = nullptr);

    // `unit` of the volume's values may be empty. Deselects a point that no longer exists.
    void setFunction(TransferFunction function, const scene::ValueMap& map, const QString& unit);
    void clear();
    // The volume's histogram; nothing: unknown, or only padding.
    void setHistogram(std::optional<scene::Histogram> histogram);

    // Spans all points and all values that are not rare.
    void fitAxis();
    bool isAxisFitted() const { return isAxisFitted_; }  // not zoomed since fitAxis
    const scene::ValueAxis& axis() const { return axis_; }
    const scene::ValueMap& valueMap() const { return map_; }

    // Ends a mouse or key edit, because another function is shown.
    void cancelDrag();
    std::optional<PointId> selected() const { return selected_; }
    void select(std::optional<PointId> point);
    // The point's handle in logical pixels of this widget; outside it when the axis does not reach the point.
    QPointF placeOf(const PointId& point) const;
    QRectF plotRect() const;   // opacity 1 at its top, 0 at its bottom
    QRectF stripRect() const;  // colours
    QRectF axisRect() const;
    double keyStep() const;  // units of the volume that an arrow key moves by

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  signals:
    void edited(const macula::TransferFunction& function);   // a complete edit
    void dragged(const macula::TransferFunction& function);  // during a drag
    void dragEnded();                                        // the drag ended
    void selectionChanged();
    void colourAsked();  // for the selected colour point

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool focusNextPrevChild(bool next) override;

  private:
    static constexpr double kTicksApartPx = 80.0;  // at least

    enum class Hand { point, whole, axis };
    struct Drag {
        Hand hand = Hand::point;
        Qt::MouseButton button = Qt::LeftButton;
        QPointF from;
        TransferFunction base;  // the whole drag edits this, so that rounding does not add up
        scene::ValueAxis axis;
        PointId point = {};
        QPointF grabbedAt = {};  // offset of the handle from the pointer
    };

    bool hasFunction() const { return !function_.opacity.empty() && !function_.colour.empty(); }
    double presetValueAt(double px) const;  // px of this widget
    double opacityAtPx(double y) const;
    double valueOf(const PointId& point) const;  // of the volume
    std::size_t pointCount() const { return function_.opacity.size() + function_.colour.size(); }
    std::optional<PointId> pointAt(QPointF at) const;
    void setAxis(const scene::ValueAxis& axis, bool isFitted);
    void reveal(const PointId& point);
    void propose(const TransferFunction& function, bool isDrag);
    void dragPoint(QPointF to);
    void dragWhole(QPointF to, Qt::KeyboardModifiers modifiers);
    void beginPointDrag(const PointId& point, const QMouseEvent& event);
    void addAt(const QMouseEvent& event);
    void addSecondSelected();
    void removeSelected();
    bool nudge(int key, Qt::KeyboardModifiers modifiers);
    void nudgePoint(double right, double up, bool isFine);
    void nudgeWhole(double right, double up, bool isFine, bool isScale);
    void endNudge();
    void describe();

    void invalidate();  // drops the cached background
    QPixmap paintedBackground() const;
    void paintHistogram(QPainter& painter) const;
    void paintScales(QPainter& painter) const;
    void paintStrip(QPainter& painter) const;
    void paintCurve(QPainter& painter) const;
    void paintPoints(QPainter& painter) const;

    TransferFunction function_;
    scene::ValueMap map_;
    QString unit_;
    std::optional<scene::Histogram> histogram_;
    scene::ValueAxis axis_;
    bool isAxisFitted_ = true;
    std::optional<PointId> selected_;
    std::optional<Drag> drag_;
    bool isNudging_ = false;
    QPixmap background_;  // histogram and scales; null: to be painted
};

}  // namespace macula::viewer
