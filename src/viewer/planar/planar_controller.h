// Shows series that are no volumes, in place of the panes: X-rays, ultrasound, photographs.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "study/planar/images_state.h"
#include "study/planar/planar_display.h"
#include "study/planar/planar_images.h"
#include "viewer/context/window_context.h"
#include "viewer/planar/planar_keys.h"
#include "viewer/planar/planar_loader.h"
#include "viewer/planar/planar_pane.h"
#include "viewer/planar/planar_player.h"
#include "viewer/planar/planar_view.h"
#include "viewer/planar/volume_actions.h"

class QWidget;

namespace macula::live {
class StudyKeeper;
}

namespace macula::viewer {

class KeptImages;
class PlanarBar;
class PlanarSaving;

// `beneath`, the panes, is hidden while images are shown. Lives on the UI thread.
class PlanarController : public QObject {
    Q_OBJECT

  public:
    PlanarController(const WindowContext& context, QWidget& beneath);

    // How series are left is kept there; null: nowhere. Stores what waits.
    void keepIn(std::shared_ptr<live::StudyKeeper> keeper);
    QWidget& widget() const { return *widget_; }
    PlanarView& view() const { return *view_; }
    PlanarMeasuring& measuring() const { return pane_->measuring(); }
    PlanarPresenting& presenting() const { return pane_->presenting(); }
    // From the first image, or as it was left. Does nothing for a stack that is not among the folder's
    // images.
    void show(std::shared_ptr<const study::FoundVolumes> found, const dicom::Stack* stack);
    void close();  // shows the panes again
    bool isShown() const { return found_ != nullptr; }
    const dicom::Stack* stack() const { return series_.stack; }
    void showNames(bool shown);
    std::optional<study::Identity> identity() const;  // of the images; nothing: none are shown

    void setPlace(std::size_t place);
    std::size_t place() const { return place_; }
    void setPlaying(bool plays);
    bool isPlaying() const { return player_.isPlaying(); }
    const study::PlanarDisplay& display() const { return pane_->shown().display(); }
    bool isUpToDate() const { return pane_->hasImage() && pane_->image().place == place_; }
    // Each does nothing, and returns false, while no images are shown.
    bool savePicture();
    bool saveMeasurements();
    bool removeMeasurements();

  Q_SIGNALS:
    void shownChanged();
    void imageShown();

  private:
    void connectParts();
    void onKey(PlanarKey key);
    bool chooseTool(PlanarKey key);
    void onEscape();
    void stepBy(int images);
    void take(const LoadedImage& image);
    void goToPresented();
    void tellFailure(std::size_t place, const Error& error);
    void tell();
    QStringList warnings() const;
    const study::PlanarLoop& loopAt(std::size_t place) const;
    double msOf(std::size_t place) const;
    void playNext();
    void keep();
    void restore();

    WindowContext context_;
    QWidget& beneath_;
    QWidget* widget_;
    PlanarView* view_;
    PlanarBar* bar_;
    PlanarPane* pane_;
    PlanarLoader* loader_;
    PlanarSaving* saving_;
    KeptImages* kept_;
    VolumeActions volumeActions_;

    std::shared_ptr<const study::FoundVolumes> found_;  // null: no images are shown
    study::PlanarSeries series_;
    std::vector<study::PlanarLoop> loops_;
    std::size_t place_ = 0;
    std::optional<study::ImagesState> left_;  // as a person left the series, until its image is shown
    bool namesShown_ = true;

    PlanarPlayer player_;
    bool playsBackwards_ = false;
};

}  // namespace macula::viewer
