// The keys over images. Letters are shortcuts of the window too: over an image they are its own.
#pragma once

#include <QObject>

class QWidget;

namespace macula::viewer {

enum class PlanarKey {
    play,
    back,
    forward,
    first,
    last,
    remove,
    label,  // the last of those that controls keep for themselves
    invert,
    turn,
    mirror,
    fit,
    closer,
    farther,
    window,
    distance,
    angle,
    ellipse,
    cobb,
    overlays,
    alone,
    link,
    escape,
};

// Watches the view and the controls below it. Lives on the UI thread.
class PlanarKeys : public QObject {
    Q_OBJECT

  public:
    PlanarKeys(QWidget& view, QWidget& bar, QObject* parent);

  Q_SIGNALS:
    void pressed(macula::viewer::PlanarKey key);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget& view_;
};

}  // namespace macula::viewer
