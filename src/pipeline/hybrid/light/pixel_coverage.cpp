#include "pipeline/hybrid/light/pixel_coverage.h"

#include <algorithm>

#include "base/check.h"

namespace macula::hybrid {

std::vector<float> pixelCoverage(std::span<const trace::GuidePixel> guides, const glm::ivec2& sizePx) {
    std::vector<float> atCentres(guides.size());
    std::transform(guides.begin(), guides.end(), atCentres.begin(),
                   [](const trace::GuidePixel& guide) { return guide.coverage; });
    return pixelCoverageOf(atCentres, sizePx);
}

std::vector<float> pixelCoverageOf(std::span<const float> atCentres, const glm::ivec2& sizePx) {
    MACULA_CHECK_EQ(atCentres.size(), std::size_t(sizePx.x) * std::size_t(sizePx.y));
    // The mean over the middle pixel of a function that is linear between three centres.
    const auto mean = [](float before, float here, float after) {
        return 0.125f * before + 0.75f * here + 0.125f * after;
    };
    // First along rows, then along columns of that.
    const auto indexOf = [&](int x, int y) {
        const int column = std::clamp(x, 0, sizePx.x - 1);
        const int row = std::clamp(y, 0, sizePx.y - 1);
        return std::size_t(row) * std::size_t(sizePx.x) + std::size_t(column);
    };
    std::vector<float> ofRows;
    ofRows.reserve(atCentres.size());
    for (int y = 0; y < sizePx.y; ++y) {
        for (int x = 0; x < sizePx.x; ++x) {
            ofRows.push_back(
                mean(atCentres[indexOf(x - 1, y)], atCentres[indexOf(x, y)], atCentres[indexOf(x + 1, y)]));
        }
    }
    std::vector<float> covered;
    covered.reserve(atCentres.size());
    for (int y = 0; y < sizePx.y; ++y) {
        for (int x = 0; x < sizePx.x; ++x) {
            covered.push_back(
                mean(ofRows[indexOf(x, y - 1)], ofRows[indexOf(x, y)], ofRows[indexOf(x, y + 1)]));
        }
    }
    return covered;
}

}  // namespace macula::hybrid
