#include "pipeline/hybrid/views/asked_views.h"

namespace macula::hybrid {

void AskedViews::add(const Camera& camera) {
    constexpr std::size_t kMostAsked = 8;
    cameras_.push_back(camera);
    if (cameras_.size() > kMostAsked) cameras_.erase(cameras_.begin());
}

void AskedViews::came(const splat::RasterView& from, const glm::dvec3& originMm, double radiusMm,
                      const AdmissionOptions& options) {
    std::erase_if(cameras_, [&](const Camera& camera) {
        const auto asked = splat::rasterView(camera, sizePx_, originMm);
        return asked && isSamePose(*asked, from, radiusMm, options);
    });
}

std::vector<splat::RasterView> AskedViews::views(const glm::dvec3& originMm) const {
    std::vector<splat::RasterView> views;
    for (const Camera& camera : cameras_) {
        if (const auto view = splat::rasterView(camera, sizePx_, originMm)) views.push_back(*view);
    }
    return views;
}

}  // namespace macula::hybrid
