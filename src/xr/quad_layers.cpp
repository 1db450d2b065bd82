#include "xr/quad_layers.h"

#include <utility>

#include "base/check.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"

namespace macula::xr {

Result<void> QuadLayers::make(const Session& session, Sent& sent, const glm::ivec2& sizePx) {
    MACULA_TRY(auto images, LentImages::create(session, sizePx, 1, LentImages::kColours));
    MACULA_CHECK(images.has_value());
    gpu::ImageOptions options;
    options.label = "panel";
    options.width = static_cast<std::uint32_t>(sizePx.x);
    options.height = static_cast<std::uint32_t>(sizePx.y);
    options.format = VK_FORMAT_R8G8B8A8_UNORM;
    MACULA_TRY(sent.picture, gpu::Image::create(session.device(), options));
    sent.images.emplace(std::move(*images));
    return {};
}

Result<void> QuadLayers::send(Sent& sent, const PanelPicture& picture) {
    const gpu::Image& from = *sent.picture;
    MACULA_TRY_VOID(gpu::uploadTo(from, std::as_bytes(std::span(picture.pixels()))));
    MACULA_TRY_VOID(sent.images->acquire());
    const auto copy = [&]() -> Result<void> {
        MACULA_TRY(auto recorder, gpu::Recorder::create(from.device(), "panel for the headset"));
        recorder.copy(from, {{0, 0}, {from.extent().width, from.extent().height}}, sent.images->layer(0));
        MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
        return {};
    };
    Result<void> copied = copy();
    MACULA_TRY_VOID(sent.images->release());  // in any case
    return copied;
}

Result<std::vector<XrCompositionLayerQuad>> QuadLayers::show(const Session& session,
                                                             const RoomControls& controls,
                                                             std::span<const Floating> floating) {
    std::vector<XrCompositionLayerQuad> layers;
    for (const Floating& shown : floating) {
        Sent& sent = sent_.at(std::size_t(shown.picture));
        const PanelPicture& picture = controls.picture(shown.picture);
        if (!sent.images) MACULA_TRY_VOID(make(session, sent, picture.sizePx()));
        if (const std::uint64_t number = controls.pictureNumber(shown.picture); number != sent.number) {
            MACULA_TRY_VOID(send(sent, picture));
            sent.number = number;
        }
        XrCompositionLayerQuad layer{XR_TYPE_COMPOSITION_LAYER_QUAD};
        layer.layerFlags = XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT |
                           XR_COMPOSITION_LAYER_UNPREMULTIPLIED_ALPHA_BIT;
        layer.space = session.stage();
        layer.eyeVisibility = XR_EYE_VISIBILITY_BOTH;
        layer.subImage = sent.images->part(0, picture.sizePx());
        layer.pose = toXr(shown.pose);
        layer.size = {static_cast<float>(shown.sizeM.x), static_cast<float>(shown.sizeM.y)};
        layers.push_back(layer);
    }
    return layers;
}

}  // namespace macula::xr
