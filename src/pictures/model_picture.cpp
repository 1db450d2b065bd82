#include "pictures/model_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "pipeline/splat/files/model_file.h"

namespace macula::pictures {

Result<ModelToDraw> readModelToDraw(const std::filesystem::path& path,
                                    std::optional<splat::LowPass> lowPass) {
    MACULA_TRY(splat::ModelFile file, splat::readModel(path, splat::BadSplats::repairOrNone));
    ModelToDraw model{.splats = std::move(file.splats), .notes = {}};
    splat::Splats& splats = model.splats;
    if (file.repaired.dropped > 0)
        model.notes.push_back(
            Text("{} of the model's splats hold what is no number or no rotation, or are so large "
                 "that they would fill every picture: left out.",
                 file.repaired.dropped));
    if (splats.size() == 0)
        model.notes.emplace_back(Text("The model holds no splats: the pictures are empty."));
    if (lowPass && splats.lowPass == splat::LowPass::adaptive) {
        model.notes.emplace_back(
            Text("This model is one of Macula's and has a low-pass of its own: --low-pass does nothing."));
    } else if (lowPass) {
        splats.lowPass = *lowPass;
    }
    return model;
}

namespace {

void add(ModelPicture& picture, const splat::SplatPicture& band, splat::ColourSpace space,
         const splat::DisplayOptions& display, bool withDepths) {
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(picture.displayed, splat::displayed(band.rgba, space, display));
    picture.isEmpty = picture.isEmpty && std::none_of(band.rgba.begin(), band.rgba.end(),
                                                      [](const glm::vec4& pixel) { return pixel.w > 0.0f; });
    if (!withDepths) return;
    append(picture.radiance, splat::linearRadiance(band.rgba, space));
    append(picture.depthsMm, splat::meanDepthsMm(band.rgba, band.depthSums));
}

}  // namespace

Result<ModelPicture> drawModel(splat::ModelPainter& painter, const splat::RasterView& view,
                               splat::ColourSpace space, const splat::DisplayOptions& display,
                               bool withDepths, const Progress& progress) {
    ModelPicture picture;
    picture.displayed.reserve(4 * std::size_t(view.sizePx.x) * std::size_t(view.sizePx.y));
    MACULA_TRY_VOID(painter.drawBands(view, [&](const splat::SplatPicture& band) -> Result<void> {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Stopped."), {}, {}};
        add(picture, band, space, display, withDepths);
        return {};
    }));
    return picture;
}

image::Metadata metadata(const splat::Splats& splats, const splat::DisplayOptions& display,
                         const std::string& device) {
    const bool linear = splats.colourSpace == splat::ColourSpace::linear;
    const glm::vec3& background = display.background;
    return {
        {"Software", "Macula " MACULA_VERSION},
        {"macula:look", "splats"},
        {"macula:splats", fmt::to_string(splats.size())},
        {"macula:colours", linear ? "linear" : "display"},
        {"macula:exposure", linear ? fmt::format("{:.6g}", display.exposure) : "none"},
        {"macula:background", fmt::format("{:.6g},{:.6g},{:.6g}", background.r, background.g, background.b)},
        {"macula:device", device}};
}

Result<void> writeModelPicture(const ModelPicture& picture, const glm::ivec2& sizePx,
                               const std::filesystem::path& png, const std::filesystem::path& exr,
                               const image::Metadata& metadata) {
    if (!exr.empty()) {
        MACULA_TRY_VOID(image::writeExr(exr, sizePx.x, sizePx.y,
                                        std::span(&picture.radiance.front().x, picture.radiance.size() * 4),
                                        picture.depthsMm, metadata));
    }
    return image::writePng(png, sizePx.x, sizePx.y, picture.displayed, metadata);
}

}  // namespace macula::pictures
