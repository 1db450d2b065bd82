// Fills the status line: with the state of the picture on screen, and with events of the render thread.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>

#include "live/frame/render_events.h"
#include "study/open/identity.h"
#include "viewer/context/window_context.h"

class QStatusBar;
class QToolBar;

namespace macula::viewer {

class ElidingLabel;
class FidelityBadge;
class PanesController;

// The line describes the 3D picture only while a pane shows it, and never that of another study. Lives on the
// UI thread.
class StatusController : public QObject {
    Q_OBJECT

  public:
    // `panes` lives until the window's destructor.
    StatusController(const WindowContext& context, const PanesController& panes);

    void addDescription(QToolBar& bar);  // the open study's description
    void addTo(QStatusBar& bar);

    void showTexts();  // the open study's texts, or those of images that are shown instead
    // Images of that patient and study are shown instead of the open study; nothing: no longer.
    void setImagesShown(std::optional<study::Identity> identity);
    void tellOfPicture();
    void onStudyShown();

    QString description() const;
    QString voxels() const;
    QString rate() const;  // pixels, and pictures per second in motion
    QString fidelity() const;
    QString badge() const;  // fidelity in a word
    QString model() const;  // the state of the peripheral model

  Q_SIGNALS:
    void frameShown(const macula::live::FrameShown& frame);

  private:
    void makeTimers();
    void onRendered(const live::RenderEvent& event);
    void onDeviceReady(const live::DeviceReady& ready);
    void onDeviceRestarting();
    void onFailure(const live::RenderFailure& failure);
    void onFrame(const live::FrameShown& frame);
    void onModel(const hybrid::ModelNews& model);
    void tellOfFrame(const live::FrameShown& frame);

    WindowContext context_;
    const PanesController& panes_;
    std::optional<study::Identity> images_;  // shown instead of the open study
    bool deviceIsBack_ = true;
    bool pictureFailed_ = false;  // of the open study
    bool isFirstStart_ = false;   // live::DeviceReady
    QString preparing_;           // what the device prepares
    QTimer prepares_;             // after this delay the status line says so
    QTimer rateEnds_;             // fires after a pause without frames
    FidelityBadge* badge_;
    ElidingLabel* description_;
    ElidingLabel* fidelity_;
    ElidingLabel* volumeText_;
    ElidingLabel* modelText_;
    ElidingLabel* pictureText_;
    ElidingLabel* deviceText_;
};

}  // namespace macula::viewer
