// Shows the window's study in a headset, mirrors it in a panel, and passes choices both ways.
#pragma once

#include <QObject>
#include <memory>

#include "pipeline/volume/clip.h"
#include "viewer/context/window_context.h"

class QDockWidget;
class QMenu;

namespace macula::viewer {

class HeadsetMirror;
class HeadsetShow;
struct HeadsetSelection;

// Lives on the UI thread.
class HeadsetController : public QObject {
    Q_OBJECT

  public:
    explicit HeadsetController(const WindowContext& context);

    HeadsetMirror& mirror() const { return *mirror_; }  // the panel
    void setDock(QDockWidget& dock);                    // the panel's dock
    void addAction(QMenu& view);
    void begin();

  Q_SIGNALS:
    void ended();  // the headset's session ended, or could not begin

  private:
    void connectShow();
    void take(const HeadsetSelection& choice);

    WindowContext context_;
    HeadsetShow* show_;
    HeadsetMirror* mirror_;
    bool isMirrored_ = false;           // a picture of the headset has arrived
    bool isFromHeadset_ = false;        // the present change comes from the headset
    std::shared_ptr<const Clip> clip_;  // the clip shown in the headset
};

}  // namespace macula::viewer
