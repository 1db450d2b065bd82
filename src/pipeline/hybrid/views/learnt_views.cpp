#include "pipeline/hybrid/views/learnt_views.h"

#include <algorithm>

namespace macula::hybrid {

namespace {

// Bytes on the device for a pixel of a view, with its smaller copies: a third more than LossTarget takes.
constexpr double kBytesOfPixel = 27.0;

}  // namespace

double bytesOfViews(const splat::Trainer& trainer) {
    double bytes = 0.0;
    for (std::size_t i = 0; i < trainer.viewCount(); ++i)
        bytes += kBytesOfPixel * double(trainer.view(i).pixels.size());
    return bytes;
}

double meanPixelsOfViews(const splat::Trainer& trainer) {
    double pixels = 0.0;
    for (std::size_t i = 0; i < trainer.viewCount(); ++i) pixels += double(trainer.view(i).pixels.size());
    return pixels / double(std::max<std::size_t>(trainer.viewCount(), 1));
}

std::optional<std::size_t> pictureOf(const splat::Trainer& trainer, const splat::RasterView& view) {
    for (std::size_t i = 0; i < trainer.viewCount(); ++i)
        if (trainer.view(i).kind == splat::ViewKind::picture && trainer.view(i).view == view) return i;
    return std::nullopt;
}

bool hasPictureFrom(const splat::Trainer& trainer, const splat::RasterView& view, double radiusMm,
                    const AdmissionOptions& options) {
    for (std::size_t i = 0; i < trainer.viewCount(); ++i)
        if (trainer.view(i).kind == splat::ViewKind::picture &&
            isSamePose(view, trainer.view(i).view, radiusMm, options))
            return true;
    return false;
}

}  // namespace macula::hybrid
