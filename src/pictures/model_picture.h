// Draws pictures of Gaussian splat models, from Macula or other programs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "image/image_file.h"
#include "pipeline/splat/draw/displayed.h"
#include "pipeline/splat/draw/model_painter.h"
#include "pipeline/splat/draw/raster_view.h"
#include "pipeline/splat/model/splats.h"

namespace macula::pictures {

struct ModelToDraw {
    splat::Splats splats;
    std::vector<Text> notes;  // unexpected properties, for the user
};

// `lowPass` is the filter that the model was trained with, for files that do not say; Macula's own say it
// (adaptive). Fails as splat::readModel with BadSplats::repairOrNone.
Result<ModelToDraw> readModelToDraw(const std::filesystem::path& path, std::optional<splat::LowPass> lowPass);

struct ModelPicture {
    std::vector<std::uint8_t> displayed;  // 4 bytes a pixel, row 0 on top
    std::vector<glm::vec4> radiance;      // linear, premultiplied; this and depthsMm only on request
    std::vector<float> depthsMm;          // mean depth along the view, in the unit of the model
    bool isEmpty = true;                  // no pixel shows the model
};

// Draws band by band; keeps 32-bit floats only if `withDepths`. Fails as ModelPainter::drawBands, and with
// `cancelled`.
Result<ModelPicture> drawModel(splat::ModelPainter& painter, const splat::RasterView& view,
                               splat::ColourSpace space, const splat::DisplayOptions& display,
                               bool withDepths, const Progress& progress);

image::Metadata metadata(const splat::Splats& splats, const splat::DisplayOptions& display,
                         const std::string& device);

// Writes each file whole or not at all; no EXR if `exr` is empty.
Result<void> writeModelPicture(const ModelPicture& picture, const glm::ivec2& sizePx,
                               const std::filesystem::path& png, const std::filesystem::path& exr,
                               const image::Metadata& metadata);

}  // namespace macula::pictures
