// A small picture of a series.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/stack/stack.h"

namespace macula::study {

inline constexpr int kThumbnailPx = 128;

struct Thumbnail {
    int widthPx = 0;
    int heightPx = 0;
    std::vector<std::uint8_t> grey;  // row by row from the top, 0 is black
};

// Decodes only the middle image of a stack, with rows and columns as acquired; at most kThumbnailPx wide and
// high. Uses the first window of the image (PS3.3 C.11.2) unless it has a real world value mapping; otherwise
// the 1st to 99th percentile. MONOCHROME1 is inverted, padding black. Fails as dicom::loadFrame; throws
// nothing.
Result<Thumbnail> thumbnailOf(const dicom::Stack& stack, const CancelToken& cancel = {});

// Shrinks a picture to square pixels, each the mean of the area it covers; never finer than the finer of the
// two spacings. Spacings that are not positive and finite count as equal.
Thumbnail shrunk(std::span<const std::uint8_t> grey, int columns, int rows, double columnSpacingMm,
                 double rowSpacingMm);

}  // namespace macula::study
