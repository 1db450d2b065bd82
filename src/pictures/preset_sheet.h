// Draws every preset in every look on one sheet, for comparison.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/frames.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "image/image_file.h"
#include "pipeline/gpu/device.h"
#include "pipeline/volume/transfer_function.h"
#include "study/open/loaded_study.h"

namespace macula::pictures {

struct SheetRequest {
    std::shared_ptr<const Volume> volume;   // stored16
    std::vector<TransferFunction> presets;  // at least one
    ViewDirection view = ViewDirection::anterior;
    int tilePx = 160;
    int panels = 3;                      // side by side; each holds a share of the presets
    std::uint32_t samplesPerPixel = 24;  // for path-traced looks
};

// Each preset has a row of one panel, with a tile for each of trace::kLooks.
struct SheetPlace {
    int panel = 0;
    int row = 0;
};
SheetPlace placeOf(const SheetRequest& request, std::size_t preset);

// The size of the sheet in pixels.
glm::ivec2 sizeOf(const SheetRequest& request);

// Display-encoded RGBA, row 0 on top. Presets take effect as in `macula render --preset NAME`, also those for
// other units. Fails as trace::PathTracer, and with `cancelled`.
Result<std::vector<std::uint8_t>> drawSheet(const std::shared_ptr<gpu::Device>& device,
                                            const SheetRequest& request, Progress& progress);

// The preset and look of each tile, by column and row from 1, and the notes of the study.
image::Metadata metadata(const SheetRequest& request, const study::LoadedStudy& study);

}  // namespace macula::pictures
