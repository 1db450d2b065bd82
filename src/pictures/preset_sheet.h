// Every preset in every look on one sheet, to be judged at a glance.
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
#include "study/open/study_input.h"

namespace macula::app {

struct SheetRequest {
    std::shared_ptr<const Volume> volume;   // stored16
    std::vector<TransferFunction> presets;  // at least one
    ViewDirection view = ViewDirection::anterior;
    int tilePx = 160;
    int panels = 3;                      // beside each other, each with its share of the presets
    std::uint32_t samplesPerPixel = 24;  // of looks with chance
};

// A preset has a row of its panel, and in that a tile for each of trace::kLooks.
struct SheetPlace {
    int panel = 0;
    int row = 0;
};
SheetPlace placeOf(const SheetRequest& request, std::size_t preset);

// The size of the sheet in pixels.
glm::ivec2 sizeOf(const SheetRequest& request);

// RGBA for the eye, row 0 on top. Presets are drawn as `macula render --preset NAME` draws them; what is made
// for other units looks as it does there. Fails as trace::PathTracer, and with `cancelled`.
Result<std::vector<std::uint8_t>> drawSheet(const std::shared_ptr<gpu::Device>& device,
                                            const SheetRequest& request, Progress& progress);

// What each picture is of, by its column and row from 1, and what there is to say of the study.
image::Metadata metadata(const SheetRequest& request, const StudyInput& study);

}  // namespace macula::app
