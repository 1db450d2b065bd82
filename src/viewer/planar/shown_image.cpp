#include "viewer/planar/shown_image.h"

#include <QCoreApplication>
#include <cmath>

#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(ShownImage)
};

QImage imageOf(const study::PlanarPicture& picture) {
    const int bytesPerPixel = picture.isColour ? 3 : 1;
    const auto format = picture.isColour ? QImage::Format_RGB888 : QImage::Format_Grayscale8;
    const QImage borrowed(picture.bytes.data(), picture.columns, picture.rows,
                          picture.columns * bytesPerPixel, format);
    return borrowed.copy();
}

}  // namespace

void ShownImage::forget() {
    *this = {};
}

void ShownImage::setDisplay(const study::PlanarDisplay& display) {
    display_ = display;
    isDisplayOwn_ = true;
}

void ShownImage::applyState(const dicom::SoftcopyState* said) {
    presented_.reset();
    if (said == nullptr) return;
    const study::PlanarDisplay usual = study::usualDisplay(*frame_, *image_->header, *image_->pixels);
    presented_ = study::presentedOn(*said, *frame_, *image_->header, *image_->pixels, usual);
}

void ShownImage::take(const LoadedImage& image, const dicom::Frame& frame, bool isOfSameLoop,
                      const dicom::SoftcopyState* said) {
    image_ = image;
    frame_ = &frame;
    applyState(said);
    const bool saysHow = !frame.windows.empty() || !image.header->tables.empty();
    if (!isDisplayOwn_ && presented_) {
        display_ = presented_->display;
    } else if (!isDisplayOwn_ && (saysHow || !isOfSameLoop)) {
        const bool isInverted = display_.isInverted;
        display_ = study::usualDisplay(frame, *image.header, *image.pixels);
        display_.isInverted = isInverted;
    }
    if (display_.table && *display_.table >= image.header->tables.size()) display_.table.reset();
}

void ShownImage::present(const dicom::SoftcopyState* said) {
    isDisplayOwn_ = false;
    if (!image_) return;
    applyState(said);
    display_ =
        presented_ ? presented_->display : study::usualDisplay(*frame_, *image_->header, *image_->pixels);
}

bool ShownImage::hasOverlays() const {
    return image_ && (presented_ ? !presented_->overlays.empty() : !image_->pixels->overlays.empty());
}

std::vector<NamedDisplay> ShownImage::displays() const {
    if (!image_) return {};
    return displaysOf(*frame_, *image_->header, *image_->pixels, display_);
}

// Of a presentation state its own shutter counts alone, if it has one (PS3.3 C.11.12).
QImage ShownImage::picture() const {
    study::PlanarPicture picture = study::pictureOf(*image_->pixels, *image_->header, display_);
    const auto& shutter = presented_ && presented_->shutter ? presented_->shutter : image_->header->shutter;
    if (overlaysAreShown_)
        for (const dicom::OverlayMask& overlay : presented_ ? presented_->overlays : image_->pixels->overlays)
            study::addOverlay(picture, overlay);
    if (shutter) study::addShutter(picture, *shutter, image_->header->pixelHeightOverWidth);
    return imageOf(picture);
}

QStringList ShownImage::notes(bool isPresented) const {
    QStringList notes;
    if (!image_) return notes;
    if (presented_) {
        for (const Text& note : presented_->notes) notes += inWindowsLanguage(note);
    } else if (isPresented) {
        notes += Words::tr("the presentation state is not of this image, which is shown as stored");
    }
    if (image_->header->shutter || (presented_ && presented_->shutter))
        notes += Words::tr("a shutter hides part of the image");
    if (hasOverlays() && !overlaysAreShown_) notes += Words::tr("overlays are hidden");
    return notes;
}

QString ShownImage::valueText(const std::optional<QPointF>& pixel) const {
    if (!pixel || !image_ || image_->pixels->isColour()) return {};
    const auto column = std::size_t(pixel->x());
    const auto row = std::size_t(pixel->y());
    const dicom::PlanarFrame& pixels = *image_->pixels;
    if (column >= std::size_t(pixels.columns) || row >= std::size_t(pixels.rows)) return {};
    const float value = pixels.values[row * std::size_t(pixels.columns) + column];
    const QString text = std::isfinite(value) ? withLocalNumbers(QString::number(double(value), 'g', 6))
                                              : Words::tr("no value");
    return Words::tr("Column %1, row %2: %3").arg(column + 1).arg(row + 1).arg(text);
}

}  // namespace macula::viewer
