// Shows series that are no volumes, in place of the panes: X-rays, ultrasound, photographs.
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "study/planar/images_state.h"
#include "study/planar/planar_display.h"
#include "study/planar/planar_images.h"
#include "viewer/context/window_context.h"
#include "viewer/planar/annotation_layer.h"
#include "viewer/planar/planar_keys.h"
#include "viewer/planar/planar_loader.h"
#include "viewer/planar/planar_player.h"
#include "viewer/planar/planar_view.h"
#include "viewer/planar/shown_image.h"
#include "viewer/planar/volume_actions.h"

class QWidget;

namespace macula::live {
class StudyKeeper;
}

namespace macula::viewer {

class KeptImages;
class PlanarBar;
class PlanarMeasuring;
class PlanarPresenting;
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
    PlanarMeasuring& measuring() const { return *measuring_; }
    PlanarPresenting& presenting() const { return *presenting_; }
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
    const study::PlanarDisplay& display() const { return image_.display(); }
    bool isUpToDate() const { return image_.hasImage() && image_.image().place == place_; }
    void showOverlays(bool shown);
    // Each does nothing, and returns false, while no images are shown.
    bool savePicture();
    bool saveMeasurements();
    bool removeMeasurements();

  Q_SIGNALS:
    void shownChanged();
    void imageShown();

  private:
    void connectParts();
    void connectMarks();
    void onKey(PlanarKey key);
    bool chooseTool(PlanarKey key);
    void onEscape();
    void stepBy(int images);
    void take(const LoadedImage& image);
    void tellFailure(std::size_t place, const Error& error);
    void chooseDisplay(int index);
    void dragWindow(QPointF byPx);
    void setDisplay(const study::PlanarDisplay& display);
    void invert(bool isInverted);
    void turn(bool isMirroring);
    void present();
    void placeAsPresented();
    void redraw();
    void tell();
    void tellDisplays();
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
    PlanarLoader* loader_;
    AnnotationLayer annotations_;
    PlanarMeasuring* measuring_;
    PlanarPresenting* presenting_;
    PlanarSaving* saving_;
    KeptImages* kept_;
    VolumeActions volumeActions_;

    std::shared_ptr<const study::FoundVolumes> found_;  // null: no images are shown
    study::PlanarSeries series_;
    std::vector<study::PlanarLoop> loops_;
    std::size_t place_ = 0;
    ShownImage image_;                        // on screen
    std::optional<study::ImagesState> left_;  // as a person left the series, until its image is shown
    // What a presentation state last said of the place in the pane.
    struct Placed {
        PlanarTurn turn;
        std::optional<dicom::DisplayedArea> area;

        bool operator==(const Placed&) const = default;
    };
    std::optional<Placed> placed_;
    std::optional<QPointF> pointedAt_;
    bool namesShown_ = true;

    PlanarPlayer player_;
    bool playsBackwards_ = false;
};

}  // namespace macula::viewer
