#include "image/planes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"

namespace macula::image {

namespace {

// Filters a line of `count` values that lie `stride` apart.
void filterLine(const double* in, double* out, int count, std::ptrdiff_t stride,
                const std::vector<double>& weights, Edge edge) {
    const int radius = static_cast<int>(weights.size()) / 2;
    const double whole = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (int i = 0; i < count; ++i) {
        double sum = 0.0;
        double used = 0.0;
        int k = -radius - 1;
        for (const double weight : weights) {
            ++k;
            if (edge != Edge::repeat && (i + k < 0 || i + k >= count)) continue;
            used += weight;
            sum += weight * in[std::clamp(i + k, 0, count - 1) * stride];
        }
        out[i * stride] = edge == Edge::cut ? sum * whole / used : sum;
    }
}

Result<void> checkOne(const Image& image) {
    const auto fault = [](Text what) {
        return Error{ErrorCode::usage,
                     std::move(what),
                     {},
                     Text("Compare two pictures of one size, made for display.")};
    };
    if (image.width < 1 || image.height < 1 || image.channels < 1)
        return fault(Text("A picture to compare is empty."));
    if (image.encoding != Encoding::display)
        return fault(Text("A picture to compare holds linear light, not display values."));
    const bool finite =
        std::all_of(image.pixels.begin(), image.pixels.end(), [](float v) { return std::isfinite(v); });
    if (!finite) return fault(Text("A picture to compare has values that are no numbers."));
    return {};
}

int colourChannels(const Image& image) {
    return image.channels >= 3 ? 3 : 1;
}

}  // namespace

Plane filter(const Plane& plane, const std::vector<double>& alongX, const std::vector<double>& alongY,
             Edge edge) {
    Plane rows(plane.width, plane.height);
    Plane result(plane.width, plane.height);
    parallelFor(std::size_t(plane.height), [&](std::size_t y) {
        const std::size_t start = y * std::size_t(plane.width);
        filterLine(&plane.values[start], &rows.values[start], plane.width, 1, alongX, edge);
    });
    parallelFor(std::size_t(plane.width), [&](std::size_t x) {
        filterLine(&rows.values[x], &result.values[x], plane.height, plane.width, alongY, edge);
    });
    return result;
}

std::vector<Plane> colourPlanes(const Image& image) {
    std::vector<Plane> planes(std::size_t(colourChannels(image)), Plane(image.width, image.height));
    for (std::size_t c = 0; c < planes.size(); ++c) {
        for (std::size_t i = 0; i < planes[c].values.size(); ++i)
            planes[c].values[i] =
                std::clamp(double(image.pixels[i * std::size_t(image.channels) + c]), 0.0, 1.0);
    }
    return planes;
}

Plane luminanceOf(const Image& image) {
    const auto planes = colourPlanes(image);
    if (planes.size() == 1) return planes.front();
    Plane luminance(image.width, image.height);
    for (std::size_t c = 0; c < planes.size(); ++c) {
        for (std::size_t i = 0; i < luminance.values.size(); ++i)
            luminance.values[i] += kRec709[c] * planes[c].values[i];
    }
    return luminance;
}

Result<void> comparable(const Image& reference, const Image& test) {
    MACULA_TRY_VOID(checkOne(reference));
    MACULA_TRY_VOID(checkOne(test));
    if (reference.width != test.width || reference.height != test.height ||
        colourChannels(reference) != colourChannels(test)) {
        return Error{ErrorCode::usage,
                     Text("Pictures of {} x {} and {} x {} cannot be compared.", reference.width,
                          reference.height, test.width, test.height),
                     {},
                     Text("Compare two pictures of one size, both in colour or both grey.")};
    }
    return {};
}

}  // namespace macula::image
