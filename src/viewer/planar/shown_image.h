// The image on screen, and how it is shown: by its file, by a presentation state, or as a person sets it.
#pragma once

#include <QImage>
#include <QPointF>
#include <QStringList>
#include <optional>
#include <vector>

#include "dicom/stack/stack.h"
#include "study/planar/planar_presentation.h"
#include "viewer/planar/planar_displays.h"
#include "viewer/planar/planar_loader.h"

namespace macula::viewer {

// Knows no widget. Lives on the UI thread.
class ShownImage {
  public:
    void forget();                        // another series: nothing of a person's choices stays
    void dropImage() { image_.reset(); }  // it could not be read
    bool hasImage() const { return image_.has_value(); }
    const LoadedImage& image() const { return *image_; }
    const dicom::Frame& frame() const { return *frame_; }

    // `isOfSameLoop`: it follows the one before in a loop, whose window stays if the file says none: a range
    // of values for each frame would make a loop flicker. `said`: null: as stored.
    void take(const LoadedImage& image, const dicom::Frame& frame, bool isOfSameLoop,
              const dicom::SoftcopyState* said);
    // As another presentation state says, or as stored; drops a person's window.
    void present(const dicom::SoftcopyState* said);
    // What it says of this image; null: as stored, or it says nothing of it.
    const study::PresentedImage* presented() const { return presented_ ? &*presented_ : nullptr; }

    const study::PlanarDisplay& display() const { return display_; }
    bool isDisplayOwn() const { return isDisplayOwn_; }  // chosen by a person for this series
    void setDisplay(const study::PlanarDisplay& display);
    void setInverted(bool isInverted) { display_.isInverted = isInverted; }
    bool hasOverlays() const;
    void showOverlays(bool shown) { overlaysAreShown_ = shown; }
    bool overlaysAreShown() const { return overlaysAreShown_; }
    std::vector<NamedDisplay> displays() const;

    QImage picture() const;
    // What the state and the file do to the image that is not seen of itself.
    QStringList notes(bool isPresented) const;
    // "Column 3, row 4: 120"; empty without a value there.
    QString valueText(const std::optional<QPointF>& pixel) const;

  private:
    void applyState(const dicom::SoftcopyState* said);

    std::optional<LoadedImage> image_;
    const dicom::Frame* frame_ = nullptr;
    study::PlanarDisplay display_;
    std::optional<study::PresentedImage> presented_;
    bool isDisplayOwn_ = false;
    bool overlaysAreShown_ = true;
};

}  // namespace macula::viewer
