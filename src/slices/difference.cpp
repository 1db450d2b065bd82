#include "slices/difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include "base/parallel.h"

namespace macula::slices {

namespace {

constexpr double kSameMm = 1e-3;
constexpr std::size_t kMostLookedAt = 1'000'000;
constexpr double kShareInWindow = 0.99;
constexpr double kLeastWidth = 1e-6;

bool haveSameGrid(const Volume& a, const Volume& b) {
    if (a.size() != b.size()) return false;
    for (int column = 0; column < 4; ++column)
        if (!(glm::length(a.worldFromVoxel()[column] - b.worldFromVoxel()[column]) < kSameMm)) return false;
    return true;
}

Error notComparable() {
    return {
        ErrorCode::inputNotUsable,
        Text("The two phases do not lie on one grid in one unit: there is no difference of their values."),
        {},
        Text("Choose another phase.")};
}

using Colour = std::array<double, 3>;
constexpr Colour kZero{48.0, 48.0, 48.0};
constexpr Colour kAbove{255.0, 110.0, 0.0};
constexpr Colour kMost{255.0, 240.0, 150.0};
constexpr Colour kBelow{0.0, 110.0, 255.0};
constexpr Colour kLeast{160.0, 240.0, 255.0};

std::uint32_t between(const Colour& from, const Colour& to, double share) {
    std::uint32_t pixel = 0xFF;
    for (std::size_t i = 0; i < from.size(); ++i)
        pixel = pixel << 8U | std::uint32_t(std::lround(from[i] + share * (to[i] - from[i])));
    return pixel;
}

}  // namespace

Result<Volume> differenceOf(const Volume& of, const Volume& minus, const CancelToken& token) {
    if (!haveSameGrid(of, minus) || of.unit() != minus.unit() || of.unitName() != minus.unitName())
        return notComparable();
    const std::string unit = of.unitName();
    VolumeOptions options{.size = of.size(),
                          .worldFromVoxel = of.worldFromVoxel(),
                          .unit = Unit::other,
                          .modality = of.modality(),
                          .provenance = of.provenance(),
                          .unitName = unit.empty() ? "difference" : unit + " difference"};
    const glm::ivec3 size = of.size();
    try {
        std::vector<float> values(of.voxelCount());
        const std::size_t perSlice = std::size_t(size.x) * std::size_t(size.y);
        parallelFor(
            std::size_t(size.z),
            [&](std::size_t k) {
                float* at = values.data() + k * perSlice;
                for (int j = 0; j < size.y; ++j) {
                    for (int i = 0; i < size.x; ++i, ++at) {
                        const bool isPadding = of.isPadding(i, j, int(k)) || minus.isPadding(i, j, int(k));
                        *at = isPadding ? std::numeric_limits<float>::quiet_NaN()
                                        : float(of.value(i, j, int(k)) - minus.value(i, j, int(k)));
                    }
                }
            },
            token);
        if (token.cancelled()) return Error{ErrorCode::cancelled, Text("Stopped."), {}, {}};
        return Volume::createFloat(std::move(options), std::move(values));
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory,
                     Text("There is not enough memory for the difference of two phases."),
                     {},
                     Text("Close other programs.")};
    }
}

DisplayWindow symmetricWindow(const Volume& difference) {
    const std::span<const float> values = difference.floatVoxels();
    const std::size_t step = values.size() / kMostLookedAt + 1;
    std::vector<float> sizes;
    for (std::size_t n = 0; n < values.size(); n += step)
        if (const float size = std::abs(values[n]); size > 0.0F) sizes.push_back(size);  // NaN is not
    double reach = 1.0;
    if (!sizes.empty()) {
        const auto last = std::min(sizes.size() - 1, std::size_t(kShareInWindow * double(sizes.size())));
        std::ranges::nth_element(sizes, sizes.begin() + std::ptrdiff_t(last));
        reach = double(sizes[last]);
    }
    return {.center = 0.0,
            .width = std::max(2.0 * reach, kLeastWidth),
            .explanation = {},
            .function = "LINEAR_EXACT"};
}

std::vector<std::uint32_t> toDiverging(std::span<const float> values, const DisplayWindow& window) {
    std::vector<std::uint32_t> pixels(values.size(), 0xFF000000U);
    const double reach = std::max(0.5 * window.width, 0.5 * kLeastWidth);
    inChunks(values.size(), [&](std::size_t first, std::size_t count) {
        for (std::size_t n = first; n < first + count; ++n) {
            const double off = (double(values[n]) - window.center) / reach;
            if (std::isnan(off)) continue;
            const double size = std::min(std::abs(off), 1.0);
            const Colour& middle = off < 0.0 ? kBelow : kAbove;
            const Colour& end = off < 0.0 ? kLeast : kMost;
            pixels[n] =
                size < 0.5 ? between(kZero, middle, 2.0 * size) : between(middle, end, 2.0 * size - 1.0);
        }
    });
    return pixels;
}

}  // namespace macula::slices
