#include "xr/swapchain_pair.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "xr/xr_error.h"

namespace macula::xr {

namespace {

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
