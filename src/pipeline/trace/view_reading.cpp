#include "pipeline/trace/view_reading.h"

#include <algorithm>

#include "base/check.h"
#include "base/parallel.h"
#include "pipeline/trace/sampled_picture.h"

namespace macula::trace {

Result<void> beginReading(SampledPicture& picture, ViewReading& reading, const WantedReading& wanted) {
    MACULA_CHECK(wanted.primaries || wanted.colours);
    MACULA_TRY_VOID(picture.prepare());
    if (wanted.primaries) MACULA_CHECK(picture.primarySamples() > 0);
    reading.width_ = picture.view().width;
    reading.height_ = picture.view().height;
    reading.primarySamples_ = wanted.primaries ? picture.primarySamples() : 0;
    reading.areMeans_ = isDenoised(picture.settings());
    reading.meanSamples_ = picture.accumulation().plan().meanSamples();
    if (!wanted.colours) return reading.reading_.begin({&picture.accumulation().primaries()});
    MACULA_TRY(const Guides* guides, picture.guides());
    const gpu::Buffer* matters = &guides->matters().buffer();
    const gpu::Buffer* counts = &picture.accumulation().film().counts();
    const gpu::Buffer* light = &picture.accumulation().film().sums();
    if (reading.areMeans_) {
        MACULA_TRY(light, picture.denoised());
    }
    if (!wanted.primaries) return reading.reading_.begin({matters, counts, light});
    return reading.reading_.begin({&picture.accumulation().primaries(), matters, counts, light});
}

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
