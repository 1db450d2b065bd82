#include "pipeline/trace/shown_colours.h"

#include <algorithm>
#include <cmath>

#include "base/glsl_in_cpp.h"
#include "base/parallel.h"

namespace macula::trace {

namespace {

#define OUT(type) type&
#define INOUT(type) type&
#define PRECISE

struct Host : GlslInCpp<float> {
#include "lib/picture.glsl"
};

#undef OUT
#undef INOUT
#undef PRECISE

constexpr std::size_t kPixelsAtOnce = 1 << 14;

}  // namespace

std::vector<std::uint8_t> shownColours(std::span<const glm::vec4> radiance, const glm::vec3& background,
                                       const Settings& settings) {
    std::vector<std::uint8_t> bytes(radiance.size() * 4, 255);
    const auto exposure = static_cast<float>(settings.exposure);
    const bool keepsHue = settings.toneMap == ToneMap::hue;
    parallelFor((radiance.size() + kPixelsAtOnce - 1) / kPixelsAtOnce, [&](std::size_t part) {
        Host host;
        const std::size_t end = std::min(radiance.size(), (part + 1) * kPixelsAtOnce);
        for (std::size_t i = part * kPixelsAtOnce; i < end; ++i) {
            const glm::vec3 shown = host.displayColour(radiance[i], background, exposure, keepsHue);
            for (int k = 0; k < 3; ++k)
                bytes[4 * i + std::size_t(k)] =
                    static_cast<std::uint8_t>(std::lround(std::clamp(shown[k], 0.0f, 1.0f) * 255.0f));
        }
    });
    return bytes;
}

}  // namespace macula::trace
