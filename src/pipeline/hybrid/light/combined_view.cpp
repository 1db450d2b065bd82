#include "pipeline/hybrid/light/combined_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "base/parallel.h"

namespace macula::hybrid {

namespace {

constexpr double kSigmaPx = 16.0;
constexpr int kReach = int(3.0 * kSigmaPx);
constexpr std::size_t kTaps = 2 * kReach + 1;
constexpr float kMostChange = 2.0f;
constexpr float kDark = 1e-4f;  // of white: added to both, so that black has ratio 1
// Sums kept in registers side by side; a row is a whole number of such groups. With 16, GCC 12 does not
// vectorise the loop, which then takes eight times as long.
constexpr std::size_t kAtOnce = 32;

bool isKnown(const glm::vec4& pixel) {
    return std::isfinite(pixel.r) && std::isfinite(pixel.g) && std::isfinite(pixel.b) &&
           std::isfinite(pixel.a);
}

// The weights of a Gaussian filter, from -kReach to kReach.
std::array<float, kTaps> gaussian() {
    std::array<float, kTaps> weights{};
    auto weight = weights.begin();
    for (int i = -kReach; i <= kReach; ++i)
        *weight++ = static_cast<float>(std::exp(-double(i) * i / (2.0 * kSigmaPx * kSigmaPx)));
    return weights;
}

// to[i] is the sum over k of weights[k] * from[i + k * stride]. Nearly all of a picture's time is spent here.
void weigh(const float* from, std::size_t stride, const std::array<float, kTaps>& weights, float* to) {
    std::array<float, kAtOnce> sums{};
    for (const float weight : weights) {
        for (std::size_t i = 0; i < kAtOnce; ++i) sums[i] += weight * from[i];
        from += stride;
    }
    std::copy(sums.begin(), sums.end(), to);
}

// Three colours of each pixel, in rows padded with 0 to a multiple of kAtOnce numbers.
struct Plane {
    explicit Plane(const glm::ivec2& sizePx)
        : width(3 * std::size_t(sizePx.x)),
          stride((width + kAtOnce - 1) / kAtOnce * kAtOnce),
          height(std::size_t(sizePx.y)),
          values(std::make_unique_for_overwrite<float[]>(stride * height)) {}

    float* row(std::size_t y) { return values.get() + y * stride; }
    glm::vec3 at(std::size_t x, std::size_t y) const {
        const float* pixel = values.get() + y * stride + 3 * x;
        return {pixel[0], pixel[1], pixel[2]};
    }

    std::size_t width;
    std::size_t stride;
    std::size_t height;
    std::unique_ptr<float[]> values;
};

// Blurs a row of the plane by the Gaussian; fill(row) first writes its values. Weights do not add up to 1,
// because only ratios are needed.
template <class Fill>
void blurRow(Plane& plane, std::size_t y, const std::array<float, kTaps>& weights, const Fill& fill) {
    std::vector<float> wide(plane.stride + 3 * (kTaps - 1), 0.0f);
    fill(wide.data() + 3 * kReach);
    float* to = plane.row(y);
    for (std::size_t i = 0; i < plane.stride; i += kAtOnce) weigh(wide.data() + i, 3, weights, to + i);
}

// Likewise along columns, for the kAtOnce columns from `first` on.
void blurColumns(Plane& plane, std::size_t first, const std::array<float, kTaps>& weights) {
    std::vector<float> strip(kAtOnce * (plane.height + kTaps - 1), 0.0f);
    for (std::size_t y = 0; y < plane.height; ++y)
        std::copy_n(plane.row(y) + first, kAtOnce, strip.data() + kAtOnce * (y + kReach));
    for (std::size_t y = 0; y < plane.height; ++y)
        weigh(strip.data() + kAtOnce * y, kAtOnce, weights, plane.row(y) + first);
}

// Writes the light of a row where both pictures are known; other pixels stay 0.
void writeKnown(const glm::vec4* from, const glm::vec4* beside, std::size_t count, float* to) {
    for (std::size_t x = 0; x < count; ++x, to += 3) {
        if (!isKnown(from[x]) || !isKnown(beside[x])) continue;
        for (int c = 0; c < 3; ++c) to[c] = from[x][c] + kDark;
    }
}

}  // namespace

TracedView combined(const TracedView& traced, TracedView lit, double tracedShare) {
    const std::array<float, kTaps> weights = gaussian();
    const auto columns = std::size_t(lit.sizePx.x);
    Plane wanted(lit.sizePx);
    Plane had(lit.sizePx);
    parallelFor(wanted.height, [&](std::size_t y) {
        const glm::vec4* ofTraced = traced.rgba.data() + y * columns;
        const glm::vec4* ofLit = lit.rgba.data() + y * columns;
        blurRow(wanted, y, weights, [&](float* row) { writeKnown(ofTraced, ofLit, columns, row); });
        blurRow(had, y, weights, [&](float* row) { writeKnown(ofLit, ofTraced, columns, row); });
    });
    const std::size_t groups = wanted.stride / kAtOnce;
    parallelFor(2 * groups, [&](std::size_t i) {
        blurColumns(i < groups ? wanted : had, i % groups * kAtOnce, weights);
    });
    parallelFor(wanted.height, [&](std::size_t y) {
        for (std::size_t x = 0; x < columns; ++x) {
            glm::vec4& pixel = lit.rgba[y * columns + x];
            const glm::vec4& own = traced.rgba[y * columns + x];
            if (!isKnown(pixel)) {
                pixel = own;
                continue;
            }
            glm::vec3 light(pixel);
            const glm::vec3 before = had.at(x, y);
            // 0 means that no pixel nearby is known in both pictures.
            if (before.x > 0.0f)
                light *= glm::clamp(wanted.at(x, y) / before, 1.0f / kMostChange, kMostChange);
            if (isKnown(own)) light = glm::mix(light, glm::vec3(own), float(tracedShare));
            pixel = glm::vec4(light, pixel.a);
        }
    });
    lit.samplesPerPixel = traced.samplesPerPixel;
    return lit;
}

}  // namespace macula::hybrid
