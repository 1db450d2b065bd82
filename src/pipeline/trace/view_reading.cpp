#include "pipeline/trace/view_reading.h"

#include <algorithm>

#include "base/parallel.h"

namespace macula::trace {

std::span<const shared::PrimaryVertex> ViewReading::primaries() const {
    if (primarySamples_ == 0) return {};
    const std::size_t pixels = std::size_t(width_) * std::size_t(height_);
    return reading_.part<shared::PrimaryVertex>(0).first(primarySamples_ * pixels);
}

TracedColours ViewReading::colours() const {
    const std::size_t first = primarySamples_ == 0 ? 0 : 1;
    const auto matters = reading_.part<glm::vec4>(first);
    const auto samples = reading_.part<std::uint32_t>(first + 1);
    const auto light = reading_.part<glm::vec4>(first + 2);
    TracedColours colours{.width = width_,
                          .height = height_,
                          .radiance = {},
                          .samples = {},
                          .coverage = {},
                          .meanSamples = meanSamples_};
    colours.radiance.resize(light.size());
    colours.samples.resize(light.size());
    colours.coverage.resize(light.size());
    constexpr std::size_t kPixelsAtOnce = 1u << 15;
    parallelFor((light.size() + kPixelsAtOnce - 1) / kPixelsAtOnce, [&](std::size_t part) {
        const std::size_t end = std::min((part + 1) * kPixelsAtOnce, light.size());
        for (std::size_t i = part * kPixelsAtOnce; i < end; ++i) {
            const float count = areMeans_ ? 1.0f : static_cast<float>(std::max(samples[i], 1u));
            colours.radiance[i] = light[i] / count;
            colours.samples[i] = samples[i];
            colours.coverage[i] = matters[i].w;
        }
    });
    return colours;
}

}  // namespace macula::trace
