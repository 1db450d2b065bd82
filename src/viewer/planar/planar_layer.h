// Something that lies over an image: measurements, the marks of a presentation state.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QTransform>

class QPainter;

namespace macula::viewer {

class PlanarView;

class PlanarLayer {
  public:
    virtual ~PlanarLayer() = default;
    // Over the picture, in logical pixels of the pane, with antialiasing. `paneFromPicture` maps pixels of
    // the image; `area` is where the displayed area lies in the pane.
    virtual void paint(QPainter& painter, const QTransform& paneFromPicture, const QRectF& area) = 0;
    // The left button, at a place in the pane; true: the layer takes it, and what follows up to the release.
    virtual bool press(const QPointF&) { return false; }
    virtual void drag(const QPointF&) {}
    virtual void release(const QPointF&) {}
    virtual void hover(const QPointF&) {}  // without a button
    virtual bool doubleClick(const QPointF&) { return false; }

  protected:
    PlanarLayer() = default;
    PlanarLayer(const PlanarLayer&) = default;
    PlanarLayer& operator=(const PlanarLayer&) = default;
};

}  // namespace macula::viewer
