// One image on screen: its picture, its marks and its texts, and what a person changes of them.
#pragma once

#include <QObject>
#include <QPointF>
#include <QStringList>
#include <optional>

#include "study/planar/images_state.h"
#include "viewer/planar/annotation_layer.h"
#include "viewer/planar/localizer_layer.h"
#include "viewer/planar/planar_view.h"
#include "viewer/planar/shown_image.h"

namespace macula::viewer {

class PlanarBar;
class PlanarMeasuring;
class PlanarPresenting;

// Lives on the UI thread.
class PlanarPane : public QObject {
    Q_OBJECT

  public:
    // Both outlive this, and the measurements live with the view.
    PlanarPane(PlanarView& view, PlanarBar& bar, QObject* parent);

    LocalizerLayer& localizer() { return localizer_; }
    PlanarMeasuring& measuring() const { return *measuring_; }
    PlanarPresenting& presenting() const { return *presenting_; }
    const ShownImage& shown() const { return image_; }
    bool hasImage() const { return image_.hasImage(); }
    const LoadedImage& image() const { return image_.image(); }

    // Another series, as stored; null: none. Until an image is taken, the view shows `message`.
    void forget(const study::FoundVolumes* found, const study::PlanarSeries& series, const QString& message);
    // The frame outlives it.
    void take(const LoadedImage& image, const dicom::Frame& frame, bool isOfSameLoop);
    void fail(const QString& message);  // instead of the image
    // Windows and presentation states in the bar.
    void tellChoices(bool withNames);
    // The texts over the image, beside those that are given.
    void tell(PlanarLabels labels);

    void invert(bool isInverted);
    void turn(bool isMirroring);
    void showOverlays(bool shown);
    // What is kept of it, but its place.
    study::ImagesState state() const;
    void restore(const study::ImagesState& state);

  Q_SIGNALS:
    void changed();  // what is kept
    void labelsNeeded();
    void choicesNeeded();

  private:
    void chooseDisplay(int index);
    void dragWindow(QPointF byPx);
    void setDisplay(const study::PlanarDisplay& display);
    void present();
    void placeAsPresented();
    void redraw();
    QStringList warnings() const;

    PlanarView& view_;
    PlanarBar& bar_;
    LocalizerLayer localizer_;
    AnnotationLayer annotations_;
    PlanarMeasuring* measuring_;
    PlanarPresenting* presenting_;
    ShownImage image_;
    // What a presentation state last said of the place in the pane.
    struct Placed {
        PlanarTurn turn;
        std::optional<dicom::DisplayedArea> area;

        bool operator==(const Placed&) const = default;
    };
    std::optional<Placed> placed_;
    std::optional<QPointF> pointedAt_;
};

}  // namespace macula::viewer
