#include "pipeline/splat/draw/displayed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "base/parallel.h"
#include "pipeline/splat/draw/reference_host.h"
#include "pipeline/splat/model/constant_colour.h"

namespace macula::splat {

namespace {

using Host = reference::HostSingle;

constexpr std::size_t kPixelsAtOnce = 1 << 14;

void overPixels(std::size_t count, const std::function<void(std::size_t)>& body) {
    parallelFor((count + kPixelsAtOnce - 1) / kPixelsAtOnce, [&](std::size_t chunk) {
        const std::size_t end = std::min(count, (chunk + 1) * kPixelsAtOnce);
        for (std::size_t i = chunk * kPixelsAtOnce; i < end; ++i) body(i);
    });
}

std::uint8_t byteOf(float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

// Computes display colours, not clamped.
class Display {
  public:
    Display(ColourSpace space, const DisplayOptions& options)
        : host_({}, {}),
          space_(space),
          background_(options.background),
          linear_(host_.decodeSrgb(background_.x), host_.decodeSrgb(background_.y),
                  host_.decodeSrgb(background_.z)),
          exposure_(options.exposure) {}

    glm::vec3 colourOf(const glm::vec4& p) {
        return space_ == ColourSpace::linear
                   ? host_.displayColour(p, linear_, exposure_, false)
                   : glm::vec3(p) + background_ * (1.0f - std::clamp(p.w, 0.0f, 1.0f));
    }

  private:
    Host host_;
    ColourSpace space_;
    glm::vec3 background_;
    glm::vec3 linear_;
    float exposure_;
};

}  // namespace

std::vector<std::uint8_t> displayed(std::span<const glm::vec4> pixels, ColourSpace space,
                                    const DisplayOptions& options) {
    Display display(space, options);
    std::vector<std::uint8_t> bytes(pixels.size() * 4);
    overPixels(pixels.size(), [&](std::size_t i) {
        const glm::vec3 shown = display.colourOf(pixels[i]);
        for (int k = 0; k < 3; ++k) bytes[4 * i + std::size_t(k)] = byteOf(shown[k]);
        bytes[4 * i + 3] = 255;
    });
    return bytes;
}

std::vector<glm::vec3> displayedExactly(std::span<const glm::vec4> pixels, ColourSpace space,
                                        const DisplayOptions& options) {
    Display display(space, options);
    std::vector<glm::vec3> colours(pixels.size());
    overPixels(pixels.size(), [&](std::size_t i) {
        colours[i] = glm::clamp(display.colourOf(pixels[i]), glm::vec3(0.0f), glm::vec3(1.0f));
    });
    return colours;
}

float lightOfGrey(float encoded, bool keepsHue) {
    Host host({}, {});
    return host.greyBeforeToneMap(std::clamp(encoded, 0.0f, 1.0f), keepsHue);
}

std::vector<glm::vec4> linearRadiance(std::span<const glm::vec4> pixels, ColourSpace space) {
    std::vector<glm::vec4> result(pixels.begin(), pixels.end());
    if (space == ColourSpace::linear) return result;
    Host host({}, {});
    overPixels(result.size(), [&](std::size_t i) {
        glm::vec4& p = result[i];
        if (!(p.w > 0.0f)) return;
        for (int k = 0; k < 3; ++k) p[k] = p.w * host.decodeSrgb(p[k] / p.w);
    });
    return result;
}

Splats asDisplayed(Splats splats) {
    if (splats.colourSpace == ColourSpace::display) return splats;
    // The most by which a coefficient of the first degree changes a colour: the slope of the display curve is
    // taken over this span.
    constexpr float kReach = 0.48860251f;
    Host host({}, {});
    const auto shown = [&](const glm::vec3& linear) {
        return host.displayColour(glm::vec4(glm::max(linear, glm::vec3(0.0f)), 1.0f), glm::vec3(0.0f), 1.0f,
                                  false);
    };
    const std::size_t count = shCount(splats.shDegree);
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const glm::vec3 colour = colourOfDc(splats.dc[i]);
        splats.dc[i] = dcOfColour(shown(colour));
        for (std::size_t k = 0; k < count; ++k) {
            glm::vec3& sh = splats.sh[i * count + k];
            sh = (shown(colour + kReach * sh) - shown(colour - kReach * sh)) / (2.0f * kReach);
        }
    }
    splats.colourSpace = ColourSpace::display;
    return splats;
}

std::vector<float> meanDepthsMm(std::span<const glm::vec4> pixels, std::span<const float> depthSums,
                                float minCoverage) {
    MACULA_CHECK_EQ(pixels.size(), depthSums.size());
    std::vector<float> depths(pixels.size(), std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < depths.size(); ++i) {
        if (pixels[i].w > minCoverage) depths[i] = depthSums[i] / pixels[i].w;
    }
    return depths;
}

}  // namespace macula::splat
