// Questions about the views of a trainer.
#pragma once

#include <cstddef>
#include <optional>

#include "pipeline/hybrid/views/training_views.h"
#include "pipeline/splat/train/trainer.h"

namespace macula::hybrid {

// An upper estimate of the device memory that they take.
double bytesOfViews(const splat::Trainer& trainer);
// Mean number of pixels of a view; 0 without views.
double meanPixelsOfViews(const splat::Trainer& trainer);

// The index of the picture with exactly this view, if any.
std::optional<std::size_t> pictureOf(const splat::Trainer& trainer, const splat::RasterView& view);
// Whether there is a picture from there (isSamePose).
bool hasPictureFrom(const splat::Trainer& trainer, const splat::RasterView& view, double radiusMm,
                    const AdmissionOptions& options);

}  // namespace macula::hybrid
