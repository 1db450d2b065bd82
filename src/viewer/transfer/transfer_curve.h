// An editable plot of a transfer function: opacity over a histogram, colours, and the axis of values below.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QString>
#include <QWidget>
#include <optional>

#include "pipeline/volume/transfer_function.h"
#include "scene/transfer/histogram.h"
#include "scene/transfer/value_axis.h"
#include "viewer/transfer/transfer_edits.h"
#include "viewer/transfer/transfer_hand.h"
#include "viewer/transfer/transfer_plot.h"

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
    void fitAxis() { plot_.fitAxis(); }
    bool isAxisFitted() const { return plot_.isAxisFitted(); }  // not zoomed since fitAxis
    const scene::ValueAxis& axis() const { return plot_.axis(); }
    const scene::ValueMap& valueMap() const { return plot_.map(); }

    // Ends a mouse or key edit, because another function is shown.
    void cancelDrag();
    std::optional<PointId> selected() const { return edits_.selected(); }
    void select(std::optional<PointId> point) { edits_.select(point); }
    // The point's handle in logical pixels of this widget; outside it when the axis does not reach the point.
    QPointF placeOf(const PointId& point) const { return plot_.placeOf(point); }
    QRectF plotRect() const { return plot_.layout().plot; }    // opacity 1 at its top, 0 at its bottom
    QRectF stripRect() const { return plot_.layout().strip; }  // colours
    QRectF axisRect() const { return plot_.layout().axis; }
    double keyStep() const { return plot_.keyStep(); }  // units of the volume that an arrow key moves by

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  Q_SIGNALS:
    void edited(const macula::TransferFunction& function);   // a complete edit
    void dragged(const macula::TransferFunction& function);  // during a drag
    void dragEnded();                                        // the drag ended
    void selectionChanged();
    void colourAsked();  // a person wants to edit the selected point's colour

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
    void listen();
    void describe();
    void forgetBackground();

    TransferPlot plot_;
    TransferEdits edits_;
    TransferHand hand_;
    TransferKeys keys_;
    TransferPainting painting_;
};

}  // namespace macula::viewer
