#include "segment/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/parallel.h"

namespace macula::segment {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

void takeNearer(std::span<float> to, std::span<const float> from, float more) {
    for (std::size_t n = 0; n < to.size(); ++n) to[n] = std::min(to[n], from[n] + more);
}

// One axis of the squared distance: each line (of `length` elements) takes the least of the lines beside it,
// each farther by the square of its offset. Of a line beside itself the elements are the lines.
void spread(std::span<const float> from, std::span<float> to, std::size_t lines, std::size_t length,
            double spacingMm, double reachMm) {
    std::copy(from.begin(), from.end(), to.begin());
    const auto reach = static_cast<std::size_t>(reachMm / spacingMm);
    for (std::size_t offset = 1; offset <= std::min(reach, lines - 1); ++offset) {
        const double mm = double(offset) * spacingMm;
        const auto more = static_cast<float>(mm * mm);
        const std::size_t shift = offset * length;
        const std::size_t count = (lines - offset) * length;
        takeNearer(to.first(count), from.subspan(shift, count), more);
        takeNearer(to.subspan(shift, count), from.first(count), more);
    }
}

}  // namespace

std::vector<float> distanceTo(const Grid& grid, const Mask& mask, double reachMm) {
    const auto na = std::size_t(grid.size.x);
    const auto nb = std::size_t(grid.size.y);
    const auto nc = std::size_t(grid.size.z);
    const std::size_t slice = grid.sliceSize();
    std::vector<float> squared(mask.size());
    parallelFor(nc, [&](std::size_t c) {
        std::vector<float> buffer(slice);
        const std::span<float> out(squared.data() + c * slice, slice);
        for (std::size_t n = 0; n < slice; ++n) out[n] = mask[c * slice + n] != 0 ? 0.0f : kFar;
        for (std::size_t b = 0; b < nb; ++b)
            spread(out.subspan(b * na, na), std::span(buffer).subspan(b * na, na), na, 1, grid.spacingMm.x,
                   reachMm);
        spread(buffer, out, nb, na, grid.spacingMm.y, reachMm);
    });
    // Row by row of all slices at once: what is read and written stays in the cache.
    const auto limit = static_cast<float>(reachMm * reachMm);
    std::vector<float> distance(mask.size());
    parallelFor(nb, [&](std::size_t b) {
        std::vector<float> from(nc * na);
        std::vector<float> to(nc * na);
        for (std::size_t c = 0; c < nc; ++c)
            std::copy_n(squared.data() + c * slice + b * na, na, from.data() + c * na);
        spread(from, to, nc, na, grid.spacingMm.z, reachMm);
        for (std::size_t c = 0; c < nc; ++c) {
            for (std::size_t a = 0; a < na; ++a) {
                const float value = to[c * na + a];
                distance[c * slice + b * na + a] = value <= limit ? std::sqrt(value) : kFar;
            }
        }
    });
    return distance;
}

Mask opened(const Grid& grid, const Mask& mask, double radiusMm, double reachMm,
            std::vector<float>& depthMm) {
    Mask other(mask.size());
    std::transform(mask.begin(), mask.end(), other.begin(),
                   [](std::uint8_t in) { return std::uint8_t(in != 0 ? 0 : 1); });
    depthMm = distanceTo(grid, other, reachMm);
    const auto radius = static_cast<float>(radiusMm);
    for (std::size_t n = 0; n < mask.size(); ++n) {
        other[n] = depthMm[n] > radius ? 1 : 0;
        depthMm[n] = std::min(depthMm[n], static_cast<float>(reachMm));
    }
    const std::vector<float> toCore = distanceTo(grid, other, radiusMm);
    for (std::size_t n = 0; n < mask.size(); ++n) other[n] = mask[n] != 0 && toCore[n] <= radius ? 1 : 0;
    return other;
}

}  // namespace macula::segment
