#include "xr/lent_images.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "xr/xr_error.h"

namespace macula::xr {

namespace {

// A headset that does not return an image for this long has stopped.
constexpr XrDuration kMostWaitNs = 2'000'000'000;

Result<bool> takesFormat(const Session& session, std::int64_t format) {
    const Functions& call = session.runtime().call();
    std::uint32_t count = 0;
    MACULA_XR_TRY(call.EnumerateSwapchainFormats(session.handle(), 0, &count, nullptr),
                  Text("tell which pictures it takes"));
    std::vector<std::int64_t> formats(count);
    MACULA_XR_TRY(call.EnumerateSwapchainFormats(session.handle(), count, &count, formats.data()),
                  Text("tell which pictures it takes"));
    return std::find(formats.begin(), formats.end(), format) != formats.end();
}

}  // namespace

constinit const LentImages::Kind LentImages::kColours{.format = VK_FORMAT_R8G8B8A8_SRGB,
                                                      .usage = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT |
                                                               XR_SWAPCHAIN_USAGE_TRANSFER_DST_BIT |
                                                               XR_SWAPCHAIN_USAGE_SAMPLED_BIT,
                                                      .layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};

Result<std::optional<LentImages>> LentImages::create(const Session& session, const glm::ivec2& sizePx,
                                                     std::uint32_t layers, const Kind& kind) {
    XrSwapchainCreateInfo info{XR_TYPE_SWAPCHAIN_CREATE_INFO};
    info.usageFlags = kind.usage;
    info.format = kind.format;
    info.sampleCount = 1;
    info.width = static_cast<std::uint32_t>(sizePx.x);
    info.height = static_cast<std::uint32_t>(sizePx.y);
    info.faceCount = 1;
    info.arraySize = layers;
    info.mipCount = 1;
    LentImages made(session, kind.layout);
    const XrResult created = session.runtime().call().CreateSwapchain(session.handle(), &info, &made.handle_);
    if (XR_FAILED(created)) made.handle_ = XR_NULL_HANDLE;
    // Runtimes report in various ways that they support no layers.
    const bool isOver = created == XR_ERROR_SESSION_LOST || created == XR_ERROR_INSTANCE_LOST ||
                        created == XR_ERROR_OUT_OF_MEMORY;
    if (XR_FAILED(created) && layers > 1 && !isOver) return std::optional<LentImages>();
    MACULA_XR_TRY(created, Text("keep pictures of that size"));
    MACULA_TRY_VOID(made.findImages());
    return std::optional<LentImages>(std::move(made));
}

LentImages::LentImages(LentImages&& other) noexcept
    : runtime_(std::move(other.runtime_)),
      device_(std::move(other.device_)),
      layout_(other.layout_),
      handle_(std::exchange(other.handle_, XR_NULL_HANDLE)),
      images_(std::move(other.images_)),
      lent_(other.lent_) {}

LentImages::~LentImages() {
    if (!handle_) return;
    static_cast<void>(device_->waitForAll());  // copies into the images may still run
    runtime_->call().DestroySwapchain(handle_);
}

Result<void> LentImages::findImages() {
    const Functions& call = runtime_->call();
    std::uint32_t count = 0;
    MACULA_XR_TRY(call.EnumerateSwapchainImages(handle_, 0, &count, nullptr), Text("lend its pictures"));
    std::vector<XrSwapchainImageVulkan2KHR> images(count, {XR_TYPE_SWAPCHAIN_IMAGE_VULKAN2_KHR});
    MACULA_XR_TRY(call.EnumerateSwapchainImages(handle_, count, &count,
                                                reinterpret_cast<XrSwapchainImageBaseHeader*>(images.data())),
                  Text("lend its pictures"));
    for (const XrSwapchainImageVulkan2KHR& image : images) images_.push_back(image.image);
    return {};
}

Result<void> LentImages::acquire() {
    if (lent_) return {};
    const Functions& call = runtime_->call();
    std::uint32_t index = 0;
    const XrSwapchainImageAcquireInfo acquire{XR_TYPE_SWAPCHAIN_IMAGE_ACQUIRE_INFO};
    MACULA_XR_TRY(call.AcquireSwapchainImage(handle_, &acquire, &index), Text("lend a picture"));
    XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO};
    wait.timeout = kMostWaitNs;
    const XrResult waited = call.WaitSwapchainImage(handle_, &wait);
    // An image cannot be released without a successful wait: the session is lost.
    if (waited == XR_TIMEOUT_EXPIRED) return xrError(XR_ERROR_SESSION_LOST, Text("lend a picture"));
    MACULA_XR_TRY(waited, Text("lend a picture"));
    if (index >= images_.size()) return xrError(XR_ERROR_RUNTIME_FAILURE, Text("lend a picture"));
    lent_ = index;
    return {};
}

Result<void> LentImages::release() {
    if (!lent_) return {};
    lent_.reset();
    const XrSwapchainImageReleaseInfo release{XR_TYPE_SWAPCHAIN_IMAGE_RELEASE_INFO};
    MACULA_XR_TRY(runtime_->call().ReleaseSwapchainImage(handle_, &release), Text("take a picture back"));
    return {};
}

gpu::LentLayer LentImages::layer(std::uint32_t number) const {
    MACULA_CHECK(lent_.has_value());
    return {.image = images_[*lent_], .layer = number, .layout = layout_};
}

XrSwapchainSubImage LentImages::part(std::uint32_t layer, const glm::ivec2& partPx) const {
    XrSwapchainSubImage part{};
    part.swapchain = handle_;
    part.imageRect = {{0, 0}, {partPx.x, partPx.y}};
    part.imageArrayIndex = layer;
    return part;
}

Result<std::optional<SwapchainPair>> SwapchainPair::create(const Session& session, const glm::ivec2& sizePx,
                                                           const LentImages::Kind& kind) {
    MACULA_TRY(const bool isTaken, takesFormat(session, kind.format));
    if (!isTaken) return std::optional<SwapchainPair>();
    SwapchainPair pair(session.device(), sizePx);
    MACULA_TRY(auto layers, LentImages::create(session, sizePx, kViews, kind));
    if (layers) {
        pair.chains_.push_back(std::move(*layers));
        return std::optional<SwapchainPair>(std::move(pair));
    }
    for (std::size_t view = 0; view < kViews; ++view) {
        MACULA_TRY(auto single, LentImages::create(session, sizePx, 1, kind));
        MACULA_CHECK(single.has_value());
        pair.chains_.push_back(std::move(*single));
    }
    return std::optional<SwapchainPair>(std::move(pair));
}

Result<void> SwapchainPair::acquire() {
    for (LentImages& chain : chains_) MACULA_TRY_VOID(chain.acquire());
    return {};
}

Result<void> SwapchainPair::release() {
    for (LentImages& chain : chains_) MACULA_TRY_VOID(chain.release());
    return {};
}

}  // namespace macula::xr
