#include "scene/lights/light_meter.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace macula::scene {

namespace {

constexpr double kBrightest = 0.05;  // the share of pixels that may be brighter

}  // namespace

std::optional<double> meteredExposure(std::span<const glm::vec4> radiance) {
    std::vector<double> luminances;
    for (const glm::vec4& pixel : radiance) {
        const double luminance = brightnessOf(glm::dvec3(pixel)) / double(pixel.w);
        if (pixel.w >= 0.5f && std::isfinite(luminance)) luminances.push_back(luminance);
    }
    if (luminances.empty()) return std::nullopt;
    const auto brighter = std::size_t(kBrightest * double(luminances.size()));
    const auto place = luminances.begin() + std::ptrdiff_t(luminances.size() - 1 - brighter);
    std::nth_element(luminances.begin(), place, luminances.end());
    return std::clamp(kMeteredLuminance / std::max(*place, 1e-12), 1.0 / kMostMetered, kMostMetered);
}

}  // namespace macula::scene
