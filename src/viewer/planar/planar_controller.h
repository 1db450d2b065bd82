// Shows series that are no volumes, in place of the panes: X-rays, ultrasound, photographs.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "study/planar/planar_display.h"
#include "study/planar/planar_images.h"
#include "viewer/context/window_context.h"
#include "viewer/planar/planar_displays.h"
#include "viewer/planar/planar_loader.h"
#include "viewer/planar/planar_player.h"
#include "viewer/planar/planar_view.h"

class QWidget;

namespace macula::viewer {

class PlanarBar;

// `beneath`, the panes, is hidden while images are shown. Lives on the UI thread.
class PlanarController : public QObject {
    Q_OBJECT

  public:
    PlanarController(const WindowContext& context, QWidget& beneath);

    QWidget& widget() const { return *widget_; }
    PlanarView& view() const { return *view_; }
    // From the first image. Does nothing for a stack that is not among the folder's images.
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
    const study::PlanarDisplay& display() const { return display_; }
    bool isUpToDate() const { return image_ && image_->place == place_; }

  Q_SIGNALS:
    void shownChanged();
    void imageShown();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void connectParts();
    bool onKey(int key);
    void stepBy(int images);
    void take(const LoadedImage& image);
    void tellFailure(std::size_t place, const Error& error);
    void chooseDisplay(int index);
    void dragWindow(QPointF byPx);
    void setDisplay(const study::PlanarDisplay& display);
    void invert(bool isInverted);
    void turn(bool isMirroring);
    void redraw();
    void tell();
    void tellDisplays();
    QStringList warnings() const;
    QString valueText() const;
    const study::PlanarLoop& loopAt(std::size_t place) const;
    std::vector<NamedDisplay> displays() const;
    double msOf(std::size_t place) const;
    void playNext();

    WindowContext context_;
    QWidget& beneath_;
    QWidget* widget_;
    PlanarView* view_;
    PlanarBar* bar_;
    PlanarLoader* loader_;

    std::shared_ptr<const study::FoundVolumes> found_;  // null: no images are shown
    study::PlanarSeries series_;
    std::vector<study::PlanarLoop> loops_;
    std::size_t place_ = 0;
    std::optional<LoadedImage> image_;  // on screen
    study::PlanarDisplay display_;
    bool isDisplayOwn_ = false;  // chosen by a person for this series
    std::optional<QPointF> pointedAt_;
    bool namesShown_ = true;

    PlanarPlayer player_;
    bool playsBackwards_ = false;
};

}  // namespace macula::viewer
