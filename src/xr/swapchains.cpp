#include "xr/swapchains.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "xr/xr_error.h"

namespace macula::xr {

namespace {

constexpr std::int64_t kFormat = VK_FORMAT_R8G8B8A8_SRGB;
constexpr std::uint32_t kEyes = 2;
// A headset that does not give an image back for so long has stopped.
constexpr XrDuration kMostWaitNs = 2'000'000'000;

Result<bool> takesFormat(const Session& session) {
    const Functions& call = session.runtime().call();
    std::uint32_t count = 0;
    MACULA_XR_TRY(call.EnumerateSwapchainFormats(session.handle(), 0, &count, nullptr),
                  "tell which pictures it takes");
    std::vector<std::int64_t> formats(count);
    MACULA_XR_TRY(call.EnumerateSwapchainFormats(session.handle(), count, &count, formats.data()),
                  "tell which pictures it takes");
    return std::find(formats.begin(), formats.end(), kFormat) != formats.end();
}

}  // namespace

Result<Swapchains> Swapchains::create(const Session& session, const glm::ivec2& sizePx) {
    MACULA_TRY(const bool isTaken, takesFormat(session));
    if (!isTaken)
        return Error{ErrorCode::deviceNotUsable,
                     "The headset takes no pictures of 8 bits in sRGB (R8G8B8A8_SRGB).", "",
                     "Update the software of the headset."};
    Swapchains swapchains(session.sharedRuntime(), session.device(), sizePx);
    MACULA_TRY(const bool hasLayers, swapchains.add(session, kEyes));
    if (!hasLayers) {
        for (std::uint32_t eye = 0; eye < kEyes; ++eye) {
            MACULA_TRY([[maybe_unused]] const bool isThere, swapchains.add(session, 1));
        }
    }
    return swapchains;
}

Swapchains::Swapchains(Swapchains&& other) noexcept
    : runtime_(std::move(other.runtime_)),
      device_(std::move(other.device_)),
      sizePx_(other.sizePx_),
      chains_(std::exchange(other.chains_, {})) {}

Swapchains::~Swapchains() {
    if (chains_.empty()) return;
    static_cast<void>(device_->waitForAll());  // copies into them
    for (const Chain& chain : chains_) runtime_->call().DestroySwapchain(chain.handle);
}

Result<bool> Swapchains::add(const Session& session, std::uint32_t layers) {
    const Functions& call = runtime_->call();
    XrSwapchainCreateInfo info{XR_TYPE_SWAPCHAIN_CREATE_INFO};
    info.usageFlags = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_TRANSFER_DST_BIT |
                      XR_SWAPCHAIN_USAGE_SAMPLED_BIT;
    info.format = kFormat;
    info.sampleCount = 1;
    info.width = static_cast<std::uint32_t>(sizePx_.x);
    info.height = static_cast<std::uint32_t>(sizePx_.y);
    info.faceCount = 1;
    info.arraySize = layers;
    info.mipCount = 1;
    Chain chain;
    const XrResult created = call.CreateSwapchain(session.handle(), &info, &chain.handle);
    // Runtimes say in many ways that they take no layers.
    const bool isOver = created == XR_ERROR_SESSION_LOST || created == XR_ERROR_INSTANCE_LOST ||
                        created == XR_ERROR_OUT_OF_MEMORY;
    if (XR_FAILED(created) && layers > 1 && !isOver) return false;
    MACULA_XR_TRY(created, "keep pictures of the size that it asks for");
    chains_.push_back(chain);

    std::uint32_t count = 0;
    MACULA_XR_TRY(call.EnumerateSwapchainImages(chain.handle, 0, &count, nullptr), "lend its pictures");
    std::vector<XrSwapchainImageVulkan2KHR> images(count, {XR_TYPE_SWAPCHAIN_IMAGE_VULKAN2_KHR});
    MACULA_XR_TRY(call.EnumerateSwapchainImages(chain.handle, count, &count,
                                                reinterpret_cast<XrSwapchainImageBaseHeader*>(images.data())),
                  "lend its pictures");
    for (const XrSwapchainImageVulkan2KHR& image : images) chains_.back().images.push_back(image.image);
    return true;
}

Result<VkImage> Swapchains::acquire(const Chain& chain) {
    const Functions& call = runtime_->call();
    std::uint32_t index = 0;
    const XrSwapchainImageAcquireInfo acquire{XR_TYPE_SWAPCHAIN_IMAGE_ACQUIRE_INFO};
    MACULA_XR_TRY(call.AcquireSwapchainImage(chain.handle, &acquire, &index), "lend a picture");
    XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO};
    wait.timeout = kMostWaitNs;
    const XrResult waited = call.WaitSwapchainImage(chain.handle, &wait);
    // An image that was not waited for cannot be given back: the session is of no more use.
    if (waited == XR_TIMEOUT_EXPIRED) return xrError(XR_ERROR_SESSION_LOST, "lend a picture");
    MACULA_XR_TRY(waited, "lend a picture");
    MACULA_CHECK_LT(static_cast<std::size_t>(index), chain.images.size());
    return chain.images[index];
}

Result<void> Swapchains::copy(const EyePictures& eyes, std::span<const gpu::Image* const> pictures,
                              std::span<const VkImage> images) {
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "copy to the headset"));
    for (std::size_t eye = 0; eye < pictures.size(); ++eye) {
        const EyePicture& shown = eyes.eyes[eye];
        recorder.copy(
            *pictures[eye],
            {{shown.firstPx.x, shown.firstPx.y},
             {static_cast<std::uint32_t>(shown.partPx.x), static_cast<std::uint32_t>(shown.partPx.y)}},
            {.image = images[chainOf(eye)], .layer = layerOf(eye)});
    }
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return {};
}

Result<std::vector<XrCompositionLayerProjectionView>> Swapchains::show(
    const EyePictures& eyes, std::span<const gpu::Image* const> pictures) {
    MACULA_CHECK_EQ(pictures.size(), std::size_t(kEyes));
    MACULA_CHECK_EQ(eyes.eyes.size(), std::size_t(kEyes));
    std::vector<VkImage> images;
    for (const Chain& chain : chains_) {
        MACULA_TRY(images.emplace_back(), acquire(chain));
    }
    const Result<void> copied = copy(eyes, pictures, images);
    // Given back in any case: the next frame wants it.
    for (const Chain& chain : chains_) {
        const XrSwapchainImageReleaseInfo release{XR_TYPE_SWAPCHAIN_IMAGE_RELEASE_INFO};
        MACULA_XR_TRY(runtime_->call().ReleaseSwapchainImage(chain.handle, &release), "take a picture back");
    }
    if (!copied) return copied.error();

    std::vector<XrCompositionLayerProjectionView> views;
    for (std::size_t i = 0; i < eyes.eyes.size(); ++i) {
        const EyePicture& shown = eyes.eyes[i];
        XrCompositionLayerProjectionView view{XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW};
        view.pose = toXr(shown.eye.pose);
        const auto angle = [](double tangent) { return static_cast<float>(std::atan(tangent)); };
        view.fov = {angle(shown.eye.left), angle(shown.eye.right), angle(shown.eye.up),
                    angle(shown.eye.down)};
        view.subImage.swapchain = chains_[chainOf(i)].handle;
        view.subImage.imageRect = {{0, 0}, {shown.partPx.x, shown.partPx.y}};
        view.subImage.imageArrayIndex = layerOf(i);
        views.push_back(view);
    }
    return views;
}

}  // namespace macula::xr
