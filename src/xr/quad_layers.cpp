#include "xr/quad_layers.h"

#include <utility>

#include "base/check.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "xr/xr_error.h"

namespace macula::xr {

namespace {

constexpr std::int64_t kFormat = VK_FORMAT_R8G8B8A8_SRGB;  // as of the eyes: swapchains.h
constexpr XrDuration kMostWaitNs = 2'000'000'000;

}  // namespace

QuadLayers::QuadLayers(QuadLayers&& other) noexcept
    : runtime_(std::move(other.runtime_)),
      device_(std::move(other.device_)),
      chains_(std::exchange(other.chains_, {})) {}

QuadLayers::~QuadLayers() {
    bool isWaitedFor = false;
    for (const Chain& chain : chains_) {
        if (!chain.handle) continue;
        if (!std::exchange(isWaitedFor, true)) static_cast<void>(device_->waitForAll());  // copies into them
        runtime_->call().DestroySwapchain(chain.handle);
    }
}

Result<void> QuadLayers::make(const Session& session, Chain& chain, const glm::ivec2& sizePx) {
    const Functions& call = runtime_->call();
    XrSwapchainCreateInfo info{XR_TYPE_SWAPCHAIN_CREATE_INFO};
    info.usageFlags = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_TRANSFER_DST_BIT |
                      XR_SWAPCHAIN_USAGE_SAMPLED_BIT;
    info.format = kFormat;
    info.sampleCount = 1;
    info.width = static_cast<std::uint32_t>(sizePx.x);
    info.height = static_cast<std::uint32_t>(sizePx.y);
    info.faceCount = 1;
    info.arraySize = 1;
    info.mipCount = 1;
    MACULA_XR_TRY(call.CreateSwapchain(session.handle(), &info, &chain.handle), "show a panel");
    std::uint32_t count = 0;
    MACULA_XR_TRY(call.EnumerateSwapchainImages(chain.handle, 0, &count, nullptr), "show a panel");
    std::vector<XrSwapchainImageVulkan2KHR> images(count, {XR_TYPE_SWAPCHAIN_IMAGE_VULKAN2_KHR});
    MACULA_XR_TRY(call.EnumerateSwapchainImages(chain.handle, count, &count,
                                                reinterpret_cast<XrSwapchainImageBaseHeader*>(images.data())),
                  "show a panel");
    chain.images.clear();
    for (const XrSwapchainImageVulkan2KHR& image : images) chain.images.push_back(image.image);
    gpu::ImageOptions options;
    options.label = "panel";
    options.width = info.width;
    options.height = info.height;
    options.format = VK_FORMAT_R8G8B8A8_UNORM;
    MACULA_TRY(chain.picture, gpu::Image::create(device_, options));
    return {};
}

Result<void> QuadLayers::send(Chain& chain, const PanelPicture& picture) {
    const Functions& call = runtime_->call();
    MACULA_TRY_VOID(gpu::uploadTo(*chain.picture, std::as_bytes(std::span(picture.pixels()))));
    std::uint32_t index = 0;
    const XrSwapchainImageAcquireInfo acquire{XR_TYPE_SWAPCHAIN_IMAGE_ACQUIRE_INFO};
    MACULA_XR_TRY(call.AcquireSwapchainImage(chain.handle, &acquire, &index), "show a panel");
    XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO};
    wait.timeout = kMostWaitNs;
    const XrResult waited = call.WaitSwapchainImage(chain.handle, &wait);
    // As of the pictures for eyes: without it the session is of no more use.
    if (waited == XR_TIMEOUT_EXPIRED) return xrError(XR_ERROR_SESSION_LOST, "show a panel");
    MACULA_XR_TRY(waited, "show a panel");
    MACULA_CHECK_LT(static_cast<std::size_t>(index), chain.images.size());
    const auto copy = [&]() -> Result<void> {
        MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "panel for the headset"));
        const VkExtent3D extent = chain.picture->extent();
        recorder.copy(*chain.picture, {{0, 0}, {extent.width, extent.height}},
                      {.image = chain.images[index], .layer = 0});
        MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
        return {};
    };
    const Result<void> copied = copy();
    const XrSwapchainImageReleaseInfo release{XR_TYPE_SWAPCHAIN_IMAGE_RELEASE_INFO};
    MACULA_XR_TRY(call.ReleaseSwapchainImage(chain.handle, &release), "take a panel back");
    return copied;
}

Result<std::vector<XrCompositionLayerQuad>> QuadLayers::show(const Session& session,
                                                             const RoomControls& controls,
                                                             std::span<const Floating> floating) {
    std::vector<XrCompositionLayerQuad> layers;
    for (const Floating& shown : floating) {
        Chain& chain = chains_.at(std::size_t(shown.picture));
        const PanelPicture& picture = controls.picture(shown.picture);
        if (!chain.handle) MACULA_TRY_VOID(make(session, chain, picture.sizePx()));
        if (const std::uint64_t number = controls.pictureNumber(shown.picture); number != chain.number) {
            MACULA_TRY_VOID(send(chain, picture));
            chain.number = number;
        }
        XrCompositionLayerQuad layer{XR_TYPE_COMPOSITION_LAYER_QUAD};
        layer.layerFlags = XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT |
                           XR_COMPOSITION_LAYER_UNPREMULTIPLIED_ALPHA_BIT;
        layer.space = session.stage();
        layer.eyeVisibility = XR_EYE_VISIBILITY_BOTH;
        layer.subImage.swapchain = chain.handle;
        layer.subImage.imageRect = {{0, 0}, {picture.sizePx().x, picture.sizePx().y}};
        layer.subImage.imageArrayIndex = 0;
        layer.pose = toXr(shown.pose);
        layer.size = {static_cast<float>(shown.sizeM.x), static_cast<float>(shown.sizeM.y)};
        layers.push_back(layer);
    }
    return layers;
}

}  // namespace macula::xr
