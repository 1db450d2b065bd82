// Shows images as they are, in boxes, in place of the panes or in a window of their own: X-rays, ultrasound,
// photographs, slices as they were acquired.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "viewer/context/window_context.h"
#include "viewer/planar/image_box.h"
#include "viewer/planar/image_boxes.h"
#include "viewer/planar/volume_actions.h"

class QWidget;

namespace macula::viewer {

class ImagesWindow;
class PlanarSaving;

// `beneath`, the panes, is hidden while images are shown in this window. What is said of an image is of the
// box that is chosen. Lives on the UI thread.
class PlanarController : public QObject {
    Q_OBJECT

  public:
    PlanarController(const WindowContext& context, QWidget& beneath);
    ~PlanarController() override;

    // How series are left is kept there; null: nowhere. Stores what waits.
    void keepIn(const std::shared_ptr<live::StudyKeeper>& keeper) { boxes_->keepIn(keeper); }
    QWidget& widget() const { return *widget_; }
    ImageBoxes& boxes() const { return *boxes_; }
    ImageBox& box() const { return boxes_->chosen(); }
    PlanarView& view() const { return box().view(); }
    PlanarMeasuring& measuring() const { return box().measuring(); }
    PlanarPresenting& presenting() const { return box().presenting(); }
    // From the first image, or as it was left: alone where nothing of that patient was shown, else in the
    // chosen box. Does nothing for a stack that is not in the folder.
    void show(const std::shared_ptr<const study::FoundVolumes>& found, const dicom::Stack* stack);
    // Boxes of one patient; they must show something.
    void showBoxes(const BoxArrangement& arrangement);
    void close();         // shows the panes again
    void giveWay();       // closes what hides the panes
    void onStudyShown();  // closes also images of another folder
    bool isShown() const { return boxes_->isShown(); }
    bool hidesPanes() const;          // shown in this window
    bool isInFront() const;           // shown, and where the keyboard acts
    void setDetached(bool detached);  // in a window of their own, for another screen
    bool isDetached() const { return window_ != nullptr; }
    const dicom::Stack* stack() const { return box().series().stack; }
    void showNames(bool shown) { boxes_->showNames(shown); }
    std::optional<study::Identity> identity() const;  // of the images; nothing: none hide the panes

    // Likewise, of the newest study of them: the one that is read.
    std::optional<study::Identity> identityOfNewest() const;

    void setPlace(std::size_t place) { box().setPlace(place); }
    std::size_t place() const { return box().place(); }
    void setPlaying(bool plays) { box().setPlaying(plays); }
    bool isPlaying() const { return box().isPlaying(); }
    const study::PlanarDisplay& display() const { return box().display(); }
    bool isUpToDate() const { return box().isUpToDate(); }
    // Each does nothing, and returns false, while images are not in front.
    bool savePicture();
    bool saveMeasurements();
    bool removeMeasurements();

  Q_SIGNALS:
    void shownChanged();
    // Images of another patient or folder are shown, the first in a box alone.
    void begun();
    void imageShown();
    void aboutToClose();  // or to show images of another patient or folder

  private:
    void present();
    void placeWidgets();

    WindowContext context_;
    QWidget& beneath_;
    QWidget* widget_;
    ImageBoxes* boxes_;
    PlanarSaving* saving_;
    VolumeActions volumeActions_;
    std::unique_ptr<ImagesWindow> window_;  // null: in this window
};

}  // namespace macula::viewer
