#include "pipeline/hybrid/light/pixel_coverage.h"

#include <algorithm>

#include "base/check.h"
#include "base/parallel.h"

namespace macula::hybrid {

namespace {

constexpr std::size_t kPixelsAtOnce = 1u << 14;

// The mean over the middle one of three pixels, of a function that is linear between their centres.
float mean(float before, float here, float after) {
    return 0.125f * before + 0.75f * here + 0.125f * after;
}

// Calls body(y) for each row, in parallel groups of rows.
template <class Body>
void forEachRow(const glm::ivec2& sizePx, const Body& body) {
    const auto rows = std::size_t(sizePx.y);
    const std::size_t atOnce =
        std::max<std::size_t>(kPixelsAtOnce / std::max(std::size_t(sizePx.x), std::size_t{1}), 1);
    parallelFor((rows + atOnce - 1) / atOnce, [&](std::size_t part) {
        for (std::size_t y = part * atOnce; y < std::min((part + 1) * atOnce, rows); ++y) body(y);
    });
}

}  // namespace

std::vector<float> pixelCoverage(std::span<const trace::GuidePixel> guides, const glm::ivec2& sizePx) {
    std::vector<float> atCentres(guides.size());
    std::transform(guides.begin(), guides.end(), atCentres.begin(),
                   [](const trace::GuidePixel& guide) { return guide.coverage; });
    return pixelCoverageOf(atCentres, sizePx);
}

std::vector<float> pixelCoverageOf(std::span<const float> atCentres, const glm::ivec2& sizePx) {
    MACULA_CHECK_EQ(atCentres.size(), std::size_t(sizePx.x) * std::size_t(sizePx.y));
    const auto columns = std::size_t(sizePx.x);
    const auto rows = std::size_t(sizePx.y);
    // The filter is separable: first along rows, then along columns.
    std::vector<float> ofRows(atCentres.size());
    forEachRow(sizePx, [&](std::size_t y) {
        const float* from = atCentres.data() + y * columns;
        float* to = ofRows.data() + y * columns;
        for (std::size_t x = 0; x < columns; ++x)
            to[x] = mean(from[x > 0 ? x - 1 : 0], from[x], from[std::min(x + 1, columns - 1)]);
    });
    std::vector<float> covered(atCentres.size());
    forEachRow(sizePx, [&](std::size_t y) {
        const float* above = ofRows.data() + (y > 0 ? y - 1 : 0) * columns;
        const float* here = ofRows.data() + y * columns;
        const float* below = ofRows.data() + std::min(y + 1, rows - 1) * columns;
        for (std::size_t x = 0; x < columns; ++x)
            covered[y * columns + x] = mean(above[x], here[x], below[x]);
    });
    return covered;
}

}  // namespace macula::hybrid
