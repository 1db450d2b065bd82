// Shows a curved plane with a section across it.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <optional>

#include "viewer/curve/curve_picture.h"

namespace macula::viewer {

// The curve runs to the right; the section at the mark is beside it. Lives on the UI thread.
class CurveView : public QWidget {
    Q_OBJECT

  public:
    explicit CurveView(QWidget* parent = nullptr);

    void show(CurvePicture picture);
    void clear(const QString& message);  // says why there is no picture
    const std::optional<CurvePicture>& picture() const { return picture_; }

    // What a picture that fills the view needs, in device pixels.
    int widthPx() const;
    int sectionPx() const;
    // The place in the volume under a place in the view; nothing beside both pictures.
    std::optional<glm::dvec3> worldAt(const QPointF& place) const;
    // The length along the curve at a place; nothing beside the curved plane.
    std::optional<double> lengthAt(const QPointF& place) const;

    QSize sizeHint() const override { return {640, 220}; }
    QSize minimumSizeHint() const override { return {240, 120}; }

  Q_SIGNALS:
    void pointed(glm::dvec3 mm, bool isDrag);  // a person clicked or dragged to a place
    void released();
    void scrolledBy(double mm);  // along the curve
    void resized();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QRectF curvedBox() const;   // of the curved picture in the view, logical pixels
    QRectF sectionBox() const;  // of the section
    void paintMarks(QPainter& painter) const;
    void paintSides(QPainter& painter) const;
    void paintTexts(QPainter& painter) const;
    QStringList notes() const;
    slices::CurvedFrame::Column columnAtMark() const;

    std::optional<CurvePicture> picture_;
    QString message_;
    std::optional<QPointF> hoverAt_;
};

}  // namespace macula::viewer
