#include "pictures/picture_effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "base/parsing.h"

namespace macula::pictures {

namespace {

Error wrong(Text message, Text hint) {
    return {ErrorCode::usage, std::move(message), {}, std::move(hint)};
}

}  // namespace

Result<void> check(const PictureEffects& effects) {
    if (!(effects.lensMm >= 0.0 && effects.lensMm <= trace::kMostLensMm))
        return wrong(Text("The diameter of the lens is not usable."),
                     Text("Give 0 to {:g} mm; 0 is none.", trace::kMostLensMm));
    if (effects.focusMm && !(*effects.focusMm > 0.0 && *effects.focusMm <= trace::kMostFocusMm))
        return wrong(Text("The distance of what is sharp is not usable."),
                     Text("Give a number above 0, up to {:g} mm, or auto.", trace::kMostFocusMm));
    if (effects.fogMm != 0.0 && !(effects.fogMm >= kLeastFogMm && effects.fogMm <= kMostFogMm))
        return wrong(Text("The depth of the fog is not usable."),
                     Text("Give {:g} to {:g} mm, or 0 for none.", kLeastFogMm, kMostFogMm));
    return {};
}

Result<std::optional<double>> parseFocus(const std::string& typed) {
    if (typed == "auto") return std::optional<double>();
    const std::optional<double> mm = parseNumber<double>(typed);
    if (!mm || !(*mm > 0.0 && *mm <= trace::kMostFocusMm))
        return Error{ErrorCode::usage, Text("The distance of what is sharp is not usable."), typed,
                     Text("Give a number above 0, up to {:g} mm, or auto.", trace::kMostFocusMm)};
    return mm;
}

Result<double> focusOfMiddle(std::span<const trace::GuidePixel> guides, glm::ivec2 sizePx,
                             const Camera& camera) {
    constexpr double kRadiusOfHeight = 0.05;
    MACULA_CHECK_EQ(guides.size(), std::size_t(sizePx.x) * std::size_t(sizePx.y));
    const glm::dvec2 size = sizePx;
    const double radiusPx = std::max(kRadiusOfHeight * size.y, 1.0);
    const double halfHeight = std::tan(glm::radians(camera.verticalFovDeg) / 2.0);
    std::vector<double> alongMm;
    for (int y = 0; y < sizePx.y; ++y) {
        for (int x = 0; x < sizePx.x; ++x) {
            const glm::dvec2 offPx = glm::dvec2(x + 0.5, y + 0.5) - 0.5 * size;
            const trace::GuidePixel& guide = guides[std::size_t(y) * std::size_t(sizePx.x) + std::size_t(x)];
            if (glm::length(offPx) > radiusPx || !(guide.depthMm >= 0.0f)) continue;
            const double aside = isParallel(camera) ? 0.0 : 2.0 * halfHeight * glm::length(offPx) / size.y;
            alongMm.push_back(double(guide.depthMm) / std::sqrt(1.0 + aside * aside));
        }
    }
    if (alongMm.empty())
        return wrong(Text("The middle of the picture shows nothing that a lens could be focused on."),
                     Text("Move the camera, or give the distance in mm of what is to be sharp: --focus-mm."));
    const auto middle = alongMm.begin() + std::ptrdiff_t(alongMm.size() / 2);
    std::nth_element(alongMm.begin(), middle, alongMm.end());
    if (!(*middle > 0.0))
        return wrong(Text("The camera stands in what the middle of the picture shows."),
                     Text("Move the camera, or give the distance in mm of what is to be sharp: --focus-mm."));
    return *middle;
}

std::vector<float> matterMm(std::span<const trace::GuidePixel> guides) {
    std::vector<float> distances(guides.size(), std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < guides.size(); ++i) {
        const trace::GuidePixel& guide = guides[i];
        if (guide.depthMm >= 0.0f) {
            distances[i] = guide.depthMm;
        } else if (guide.beforeMm >= 0.0f) {
            distances[i] = guide.beforeMm;
        }
    }
    return distances;
}

void addFog(std::span<glm::vec4> radiance, std::span<const float> distancesMm, double fogMm) {
    MACULA_CHECK_EQ(radiance.size(), distancesMm.size());
    MACULA_CHECK(fogMm > 0.0);
    float nearest = std::numeric_limits<float>::infinity();
    for (const float distance : distancesMm) nearest = std::min(nearest, distance);
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        if (!std::isfinite(distancesMm[i])) continue;
        radiance[i] *= float(std::exp(-double(distancesMm[i] - nearest) / fogMm));
    }
}

}  // namespace macula::pictures
