#include "xr/swapchains.h"

#include <cmath>
#include <utility>

#include "base/check.h"
#include "xr/image_copies.h"
#include "xr/xr_error.h"

namespace macula::xr {

namespace {

bool isAllOf(std::span<const VisiblePart> parts, const glm::ivec2& sizePx) {
    return parts.size() == 1 && parts[0] == VisiblePart{glm::ivec2(0), sizePx};
}

}  // namespace

Result<Swapchains> Swapchains::create(const Session& session, const glm::ivec2& sizePx) {
    MACULA_TRY(auto pair, SwapchainPair::create(session, sizePx, LentImages::kColours));
    if (!pair)
        return Error{ErrorCode::deviceNotUsable,
                     Text("The headset takes no pictures of 8 bits in sRGB (R8G8B8A8_SRGB)."), "",
                     Text("Update the software of the headset.")};
    return Swapchains(std::move(*pair));
}

Result<void> Swapchains::copy(const EyePictures& eyes, std::span<const gpu::Image* const> pictures,
                              std::span<const std::vector<VisiblePart>> visible) {
    MACULA_TRY(auto recorder, gpu::Recorder::create(pair_.device(), "copy to the headset"));
    for (std::size_t eye = 0; eye < pictures.size(); ++eye) {
        const EyePicture& shown = eyes.eyes[eye];
        if (eye < visible.size() && !isAllOf(visible[eye], shown.partPx)) {
            copyVisible(recorder, *pictures[eye], shown.firstPx, visible[eye], pair_.image(eye));
            continue;
        }
        recorder.copy(
            *pictures[eye],
            {{shown.firstPx.x, shown.firstPx.y},
             {static_cast<std::uint32_t>(shown.partPx.x), static_cast<std::uint32_t>(shown.partPx.y)}},
            pair_.image(eye));
    }
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return {};
}

Result<std::vector<XrCompositionLayerProjectionView>> Swapchains::show(
    const EyePictures& eyes, std::span<const gpu::Image* const> pictures,
    std::span<const std::vector<VisiblePart>> visible) {
    MACULA_CHECK_EQ(pictures.size(), SwapchainPair::kViews);
    MACULA_CHECK_EQ(eyes.eyes.size(), SwapchainPair::kViews);
    MACULA_TRY_VOID(pair_.acquire());
    const Result<void> copied = copy(eyes, pictures, visible);
    // Released even after an error: the next frame needs the images.
    MACULA_TRY_VOID(pair_.release());
    if (!copied) return copied.error();

    std::vector<XrCompositionLayerProjectionView> views;
    for (std::size_t i = 0; i < eyes.eyes.size(); ++i) {
        const EyePicture& shown = eyes.eyes[i];
        XrCompositionLayerProjectionView view{XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW};
        view.pose = toXr(shown.eye.pose);
        const auto angle = [](double tangent) { return static_cast<float>(std::atan(tangent)); };
        view.fov = {angle(shown.eye.left), angle(shown.eye.right), angle(shown.eye.up),
                    angle(shown.eye.down)};
        view.subImage = pair_.part(i, shown.partPx);
        views.push_back(view);
    }
    return views;
}

}  // namespace macula::xr
