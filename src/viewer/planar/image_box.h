// A box of the grid of images (PS3.3 C.23): a series at a place, with its controls, its loop and what is kept
// of it.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/planar/images_state.h"
#include "study/planar/planar_display.h"
#include "study/planar/planar_images.h"
#include "viewer/context/window_context.h"
#include "viewer/planar/line_layer.h"
#include "viewer/planar/planar_loader.h"
#include "viewer/planar/planar_pane.h"
#include "viewer/planar/planar_player.h"
#include "viewer/planar/planar_view.h"

namespace macula::live {
class StudyKeeper;
}

namespace macula::viewer {

class KeptImages;
class PaneFrame;
class PlanarBar;

// Frame and bar belong to whoever places them. Lives on the UI thread.
class ImageBox : public QObject {
    Q_OBJECT

  public:
    ImageBox(const WindowContext& context, QObject* parent);

    PaneFrame& frame() const { return *frame_; }
    PlanarBar& bar() const { return *bar_; }
    PlanarPane& pane() const { return *pane_; }
    PlanarView& view() const { return *view_; }
    PlanarMeasuring& measuring() const { return pane_->measuring(); }
    PlanarPresenting& presenting() const { return pane_->presenting(); }

    // How the series is left is kept there; null: nowhere. Stores what waits.
    void keepIn(std::shared_ptr<live::StudyKeeper> keeper);
    // From that image; nothing: from the first, or as it was left. `keeps` is false where another box keeps
    // that series.
    void show(std::shared_ptr<const study::FoundVolumes> found, const study::PlanarSeries& series,
              std::optional<std::size_t> place, bool keeps);
    void clear();
    bool isShown() const { return found_ != nullptr; }
    const std::shared_ptr<const study::FoundVolumes>& found() const { return found_; }
    const study::PlanarSeries& series() const { return series_; }
    bool keeps() const { return keeps_; }
    // Those that a person made in another box of the same series.
    void takeMeasurements(const std::vector<study::ImageMeasurement>& all);
    void showNames(bool shown);
    void setMostBytes(std::size_t bytes) { loader_->setMostBytes(bytes); }

    void setPlace(std::size_t place);  // as a person does
    void stepBy(int images);           // likewise, and stops the loop
    void follow(std::size_t place);    // as another box does
    std::size_t place() const { return place_; }
    const dicom::Frame& placeFrame() const { return series_.stack->frames[place_]; }  // may not be read yet
    const dicom::Frame* shownFrame() const;  // of the image on screen; null: none
    void setPlaying(bool plays);
    bool isPlaying() const { return player_.isPlaying(); }
    const study::PlanarDisplay& display() const { return pane_->shown().display(); }
    bool isUpToDate() const { return pane_->hasImage() && pane_->image().place == place_; }
    // The line of the image of another box; null: none.
    void setLineOf(const dicom::Frame* other);
    void setLinked(bool linked);             // said beside the image
    void setPrior(const std::string& date);  // likewise: YYYYMMDD of an older study; empty: it is the newest

  Q_SIGNALS:
    void shownChanged();
    void imageShown();
    void placeChosen();                      // by a person
    void restored();                         // it shows what was left
    void activated();                        // it got the keyboard focus
    void closeAsked();                       // Esc
    void aloneAsked();                       // alone, or with the others again
    void linkAsked();                        // boxes that scroll together, or not
    void saveAsked();                        // the measurements
    void dropped(const QByteArray& series);  // kSeriesMime

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void connectParts();
    void request(std::size_t place);
    void showLocalizer();
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
    PlanarView* view_;
    PaneFrame* frame_;
    PlanarBar* bar_;
    PlanarPane* pane_;
    PlanarLoader* loader_;
    KeptImages* kept_;
    LineLayer line_;

    std::shared_ptr<const study::FoundVolumes> found_;  // null: nothing is shown
    study::PlanarSeries series_;
    std::vector<study::PlanarLoop> loops_;
    std::size_t place_ = 0;
    std::optional<study::ImagesState> left_;  // as a person left the series, until its image is shown
    bool isPlaceGiven_ = false;               // the place that was left does not count
    bool keeps_ = false;
    bool isLinked_ = false;
    std::string priorDate_;
    bool namesShown_ = true;

    PlanarPlayer player_;
    bool playsBackwards_ = false;
};

}  // namespace macula::viewer
