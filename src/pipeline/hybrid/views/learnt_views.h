// The views that a trainer has.
#pragma once

#include <cstddef>
#include <optional>

#include "pipeline/hybrid/views/training_views.h"
#include "pipeline/splat/train/trainer.h"

namespace macula::hybrid {

// About what they take on the device.
double bytesOfViews(const splat::Trainer& trainer);
// Pixels of one, on average; 0 where there is none.
double meanPixelsOfViews(const splat::Trainer& trainer);

// The picture of exactly that view.
std::optional<std::size_t> pictureOf(const splat::Trainer& trainer, const splat::RasterView& view);
// Whether there is a picture from there (isSamePose).
bool hasPictureFrom(const splat::Trainer& trainer, const splat::RasterView& view, double radiusMm,
                    const AdmissionOptions& options);

}  // namespace macula::hybrid
