#include "xr/swapchain_pair.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "xr/xr_error.h"

namespace macula::xr {

namespace {

// A headset that does not give an image back for so long has stopped.
constexpr XrDuration kMostWaitNs = 2'000'000'000;

Result<bool> takesFormat(const Session& session, std::int64_t format) {
    const Functions& call = session.runtime().call();
    std::uint32_t count = 0;
    MACULA_XR_TRY(call.EnumerateSwapchainFormats(session.handle(), 0, &count, nullptr),
                  "tell which pictures it takes");
    std::vector<std::int64_t> formats(count);
    MACULA_XR_TRY(call.EnumerateSwapchainFormats(session.handle(), count, &count, formats.data()),
                  "tell which pictures it takes");
    return std::find(formats.begin(), formats.end(), format) != formats.end();
}

}  // namespace

Result<std::optional<SwapchainPair>> SwapchainPair::create(const Session& session, const glm::ivec2& sizePx,
                                                           const Kind& kind) {
    MACULA_TRY(const bool isTaken, takesFormat(session, kind.format));
    if (!isTaken) return std::optional<SwapchainPair>();
    SwapchainPair pair(session, sizePx, kind);
    MACULA_TRY(const bool hasLayers, pair.add(session, kViews));
    if (!hasLayers) {
        for (std::size_t view = 0; view < kViews; ++view) {
            MACULA_TRY([[maybe_unused]] const bool isThere, pair.add(session, 1));
        }
    }
    return std::optional<SwapchainPair>(std::move(pair));
}

SwapchainPair::SwapchainPair(SwapchainPair&& other) noexcept
    : runtime_(std::move(other.runtime_)),
      device_(std::move(other.device_)),
      sizePx_(other.sizePx_),
      kind_(other.kind_),
      chains_(std::exchange(other.chains_, {})) {}

SwapchainPair::~SwapchainPair() {
    if (chains_.empty()) return;
    static_cast<void>(device_->waitForAll());  // copies into them
    for (const Chain& chain : chains_) runtime_->call().DestroySwapchain(chain.handle);
}

Result<bool> SwapchainPair::add(const Session& session, std::uint32_t layers) {
    const Functions& call = runtime_->call();
    XrSwapchainCreateInfo info{XR_TYPE_SWAPCHAIN_CREATE_INFO};
    info.usageFlags = kind_.usage;
    info.format = kind_.format;
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

Result<void> SwapchainPair::acquire() {
    const Functions& call = runtime_->call();
    for (Chain& chain : chains_) {
        if (chain.lent) continue;
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
        chain.lent = index;
    }
    return {};
}

Result<void> SwapchainPair::release() {
    for (Chain& chain : chains_) {
        if (!chain.lent) continue;
        chain.lent.reset();
        const XrSwapchainImageReleaseInfo release{XR_TYPE_SWAPCHAIN_IMAGE_RELEASE_INFO};
        MACULA_XR_TRY(runtime_->call().ReleaseSwapchainImage(chain.handle, &release), "take a picture back");
    }
    return {};
}

gpu::LentLayer SwapchainPair::image(std::size_t view) const {
    const Chain& chain = chains_[chainOf(view)];
    MACULA_CHECK(chain.lent.has_value());
    return {.image = chain.images[*chain.lent], .layer = layerOf(view), .layout = kind_.layout};
}

XrSwapchainSubImage SwapchainPair::part(std::size_t view, const glm::ivec2& partPx) const {
    XrSwapchainSubImage part{};
    part.swapchain = chains_[chainOf(view)].handle;
    part.imageRect = {{0, 0}, {partPx.x, partPx.y}};
    part.imageArrayIndex = layerOf(view);
    return part;
}

}  // namespace macula::xr
