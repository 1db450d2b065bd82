// A small picture of a series, to know it by.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/stack/stack.h"

namespace macula::app {

inline constexpr int kThumbnailPx = 128;

struct Thumbnail {
    int widthPx = 0;
    int heightPx = 0;
    std::vector<std::uint8_t> grey;  // row by row from the top, 0 is black
};

// The middle image of a stack, which alone is decoded, with rows and columns as they were acquired; at most
// kThumbnailPx wide and high. Seen through its own first window (PS3.3 C.11.2), else from the first to the
// last hundredth of its values; MONOCHROME1 is drawn inverted, and padding black. Fails as dicom::loadFrame
// does; throws nothing.
Result<Thumbnail> thumbnailOf(const dicom::Stack& stack, const CancelToken& cancel = {});

// Shrinks a picture of columns x rows to square pixels, each the mean of what it covers; never finer than the
// finer of the two spacings. Spacings that are not positive and finite count as equal.
Thumbnail shrunk(std::span<const std::uint8_t> grey, int columns, int rows, double columnSpacingMm,
                 double rowSpacingMm);

}  // namespace macula::app
