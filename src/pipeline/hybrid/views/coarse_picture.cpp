#include "pipeline/hybrid/views/coarse_picture.h"

#include <algorithm>

#include "pipeline/splat/train/reference_loss.h"

namespace macula::hybrid {

splat::TrainingView coarselyShown(const splat::TrainingView& view, int lines) {
    const glm::ivec2 size = view.view.sizePx;
    const double step = double(size.y) / double(lines);
    splat::TrainingView shown = view;
    if (!(step > 1.0)) return shown;
    const glm::ivec2 coarse = glm::max(glm::ivec2(glm::round(glm::dvec2(size) / step)), 1);
    const glm::dvec2 pixelsOfCoarse = glm::dvec2(size) / glm::dvec2(coarse);
    const auto coarseAt = [&](const glm::ivec2& at) {
        const glm::ivec2 pixel(glm::dvec2(glm::clamp(at, glm::ivec2(0), coarse - 1)) * pixelsOfCoarse +
                               0.5 * pixelsOfCoarse);
        return view.pixels[std::size_t(pixel.y) * std::size_t(size.x) + std::size_t(pixel.x)];
    };
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const glm::dvec2 at = (glm::dvec2(x, y) + 0.5) / pixelsOfCoarse - 0.5;
            const glm::ivec2 low(glm::floor(at));
            const glm::vec2 t(at - glm::dvec2(low));
            const glm::vec4 above = glm::mix(coarseAt(low), coarseAt(low + glm::ivec2(1, 0)), t.x);
            const glm::vec4 below =
                glm::mix(coarseAt(low + glm::ivec2(0, 1)), coarseAt(low + glm::ivec2(1, 1)), t.x);
            shown.pixels[std::size_t(y) * std::size_t(size.x) + std::size_t(x)] = glm::mix(above, below, t.y);
        }
    }
    return shown;
}

double coarseDifference(const splat::TrainingView& view, int lines, const splat::LossOptions& loss) {
    const splat::TrainingView shown = coarselyShown(view, lines);
    double sum = 0.0;
    for (std::size_t i = 0; i < view.pixels.size(); ++i) {
        const glm::dvec4 target(view.pixels[i]);
        const glm::dvec4 coarse(shown.pixels[i]);
        if (glm::any(glm::isnan(target) || glm::isinf(target))) continue;
        if (glm::any(glm::isnan(coarse) || glm::isinf(coarse))) continue;
        const glm::dvec4 difference = glm::abs(splat::referenceCompared(coarse, loss, glm::dvec3(0.0)) -
                                               splat::referenceCompared(target, loss, glm::dvec3(0.0)));
        const bool isOutline = view.kind == splat::ViewKind::outline;
        sum += isOutline ? difference.w : glm::dot(difference, glm::dvec4(1.0));
    }
    return sum / (4.0 * double(std::max<std::size_t>(view.pixels.size(), 1)));
}

}  // namespace macula::hybrid
