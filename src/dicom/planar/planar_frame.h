// Decodes one frame of any image: grey, palette or colour.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/planar/planar_header.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

// Row by row from the first one. One of `values` and `rgb` is filled.
struct PlanarFrame {
    int columns = 0;
    int rows = 0;
    std::vector<float> values;               // grey, in units, before any window; NaN is padding
    std::vector<std::uint8_t> rgb;           // three bytes for each pixel
    std::vector<OverlayMask> overlays = {};  // of the file, over this frame

    bool isColour() const { return !rgb.empty(); }
};

// Decodes stack.frames[frame] alone. `header` is that of its file. Fails with inputNotUsable, outOfMemory or
// cancelled, as loadFrame.
Result<PlanarFrame> loadPlanarFrame(const Stack& stack, std::size_t frame, const PlanarHeader& header,
                                    const CancelToken& cancel = {});

}  // namespace macula::dicom
