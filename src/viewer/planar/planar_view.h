// A picture that is shown as it is: an X-ray, a frame of ultrasound, a photograph.
#pragma once

#include <QImage>
#include <QPointF>
#include <QStringList>
#include <QTransform>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "viewer/planar/planar_layer.h"
#include "viewer/planar/planar_texts.h"
#include "viewer/settings/mouse_profile.h"

namespace macula::viewer {

// The texts over an image: lines for each corner of the pane.
struct PlanarLabels {
    QStringList identity;  // top left
    QStringList place;     // top right
    QStringList display;   // bottom left
    QStringList warnings;  // bottom right
    std::array<std::string, 2> towards;
    double mmPerPixel = 0.0;  // for the scale bar; 0: none
    bool isCalibrated = true;

    void setScale(const std::optional<dicom::PixelSize>& size);  // of a film: none
};

// How a person zoomed and panned.
struct PlanarZoom {
    std::optional<double> scale;  // logical pixels for a column; nothing: fits
    QPointF middle{0.0, 0.0};     // of the displayed area from the middle of the pane

    bool operator==(const PlanarZoom&) const = default;
};

// Shows the whole picture until a person zooms or pans. Keeps the middle of the picture in the pane. Lives on
// the UI thread.
class PlanarView : public QWidget {
    Q_OBJECT

  public:
    explicit PlanarView(QWidget* parent = nullptr);

    // `heightOverWidth` of a pixel. A picture of another size is fitted.
    void setPicture(const QImage& picture, double heightOverWidth);
    void setLabels(const PlanarLabels& labels);
    void setTurn(const PlanarTurn& turn);
    const PlanarTurn& turn() const { return turn_; }
    void setMessage(const QString& message);  // instead of the picture; empty: none
    // The part that fits the pane, in pixels of the image; nothing: all of it. Fits.
    void setArea(const std::optional<QRectF>& area);
    void fit();
    void zoomBy(double factor, const QPointF& fixed);
    const PlanarZoom& zoom() const { return zoom_; }
    void setZoom(const PlanarZoom& zoom);
    // Later ones lie above, and get the mouse first. They live until the view is destroyed.
    void addLayer(PlanarLayer& layer) { layers_.push_back(&layer); }
    // What the pane shows, without names.
    QImage pictureWithoutNames() const;

    const PlanarLabels& labels() const { return labels_; }
    const QImage& picture() const { return picture_; }
    // Maps a place in the pane to pixels of the image, counted from the outer corner of the first pixel;
    // nothing where the image does not lie.
    std::optional<QPointF> pixelAt(const QPointF& place) const;
    QTransform paneFromPicture() const;

    QSize sizeHint() const override { return {720, 540}; }

  Q_SIGNALS:
    void zoomed();
    void windowDragged(QPointF byPx);  // the window: wider to the right, brighter up
    void steppedBy(int images);
    void pointedAt(std::optional<QPointF> pixel);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    void dragBy(QPointF moved, MouseDrag drag);
    QRectF area() const;
    void paint(QPainter& painter, const PlanarLabels& labels) const;
    // To lengths, in widths of a column, of the turned and mirrored image around its middle.
    QTransform shapeFromPicture() const;
    double fittingScale() const;
    void keepInPane();
    void paintLabels(QPainter& painter, const PlanarLabels& labels) const;
    void paintScale(QPainter& painter) const;

    QImage picture_;
    double heightOverWidth_ = 1.0;
    PlanarTurn turn_;
    PlanarLabels labels_;
    QString message_;
    PlanarZoom zoom_;
    std::optional<QRectF> area_;
    std::vector<PlanarLayer*> layers_;
    PlanarLayer* taken_ = nullptr;  // the layer that has the button
    QPointF lastAt_;
    QPointF pressedAt_;
    double scrollRestPx_ = 0.0;
    int wheelRest_ = 0;
};

}  // namespace macula::viewer
