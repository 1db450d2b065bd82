#include "pipeline/hybrid/light/pixel_coverage.h"

#include <algorithm>

#include "base/check.h"

namespace macula::hybrid {

std::vector<float> pixelCoverage(std::span<const trace::GuidePixel> guides, const glm::ivec2& sizePx) {
    std::vector<float> coverage(guides.size());
    std::transform(guides.begin(), guides.end(), coverage.begin(),
                   [](const trace::GuidePixel& guide) { return guide.coverage; });
    return pixelCoverage(coverage, sizePx);
}

std::vector<float> pixelCoverage(std::span<const float> coverage, const glm::ivec2& sizePx) {
    MACULA_CHECK_EQ(coverage.size(), std::size_t(sizePx.x) * std::size_t(sizePx.y));
    const auto at = [&](int x, int y) {
        const int column = std::clamp(x, 0, sizePx.x - 1);
        const int row = std::clamp(y, 0, sizePx.y - 1);
        return coverage[std::size_t(row) * std::size_t(sizePx.x) + std::size_t(column)];
    };
    // The mean over the middle pixel of a function that is linear between three centres.
    const auto mean = [](float before, float here, float after) {
        return 0.125f * before + 0.75f * here + 0.125f * after;
    };
    std::vector<float> covered;
    covered.reserve(coverage.size());
    for (int y = 0; y < sizePx.y; ++y) {
        const auto row = [&](int v, int x) { return mean(at(x - 1, v), at(x, v), at(x + 1, v)); };
        for (int x = 0; x < sizePx.x; ++x) covered.push_back(mean(row(y - 1, x), row(y, x), row(y + 1, x)));
    }
    return covered;
}

}  // namespace macula::hybrid
