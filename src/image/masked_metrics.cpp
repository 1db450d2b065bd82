#include "image/masked_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "base/srgb.h"
#include "image/planes.h"
#include "image/ssim.h"

namespace macula::image {

namespace {

// The least value that rounds to 1 of 255 or more.
constexpr double kLeast = 0.5 / 255.0;

Result<void> fits(const Image& reference, const Image& test, const Mask& mask) {
    MACULA_TRY_VOID(comparable(reference, test));
    MACULA_CHECK_EQ(mask.size(), std::size_t(reference.width) * std::size_t(reference.height));
    return {};
}

std::size_t countOf(const Mask& mask) {
    return mask.size() - static_cast<std::size_t>(std::count(mask.begin(), mask.end(), 0));
}

}  // namespace

Result<Mask> litMask(const Image& reference, const Image& test) {
    MACULA_TRY_VOID(comparable(reference, test));
    Mask mask(std::size_t(reference.width) * std::size_t(reference.height), 0);
    for (const Image* image : {&reference, &test}) {
        for (const Plane& plane : colourPlanes(*image)) {
            for (std::size_t i = 0; i < mask.size(); ++i) {
                if (plane.values[i] >= kLeast) mask[i] = 1;
            }
        }
    }
    return mask;
}

Mask coveredMask(std::span<const float> coverage) {
    Mask mask(coverage.size());
    std::transform(coverage.begin(), coverage.end(), mask.begin(),
                   [](float c) { return static_cast<std::uint8_t>(double(c) >= kLeast); });
    return mask;
}

Mask unionOf(const Mask& a, const Mask& b) {
    MACULA_CHECK_EQ(a.size(), b.size());
    Mask either(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) either[i] = a[i] != 0 || b[i] != 0 ? 1 : 0;
    return either;
}

Result<std::optional<double>> maskedPsnr(const Image& reference, const Image& test, const Mask& mask) {
    MACULA_TRY_VOID(fits(reference, test, mask));
    const std::size_t count = countOf(mask);
    if (count == 0) return std::optional<double>();
    const auto a = colourPlanes(reference);
    const auto b = colourPlanes(test);
    double squares = 0.0;
    for (std::size_t c = 0; c < a.size(); ++c) {
        for (std::size_t i = 0; i < mask.size(); ++i) {
            const double difference = mask[i] != 0 ? a[c].values[i] - b[c].values[i] : 0.0;
            squares += difference * difference;
        }
    }
    if (squares == 0.0) return std::optional(std::numeric_limits<double>::infinity());
    return std::optional(-10.0 * std::log10(squares / double(a.size() * count)));
}

Result<std::optional<double>> maskedSsim(const Image& reference, const Image& test, const Mask& mask) {
    MACULA_TRY_VOID(fits(reference, test, mask));
    const std::size_t count = countOf(mask);
    if (count == 0) return std::optional<double>();
    const auto maps = ssimMaps(reference, test, Edge::zero);
    double sum = 0.0;
    for (const Plane& map : maps) {
        for (std::size_t i = 0; i < mask.size(); ++i) sum += mask[i] != 0 ? map.values[i] : 0.0;
    }
    return std::optional(sum / double(maps.size() * count));
}

double lightOf(const Image& image, const Mask& mask) {
    MACULA_CHECK_EQ(mask.size(), std::size_t(image.width) * std::size_t(image.height));
    const auto planes = colourPlanes(image);
    double sum = 0.0;
    for (std::size_t c = 0; c < planes.size(); ++c) {
        const double weight = planes.size() == 1 ? 1.0 : kRec709[c];
        for (std::size_t i = 0; i < mask.size(); ++i) {
            if (mask[i] != 0) sum += weight * decodedSrgb(planes[c].values[i]);
        }
    }
    return sum;
}

std::optional<double> coverageError(std::span<const float> reference, std::span<const float> test,
                                    const Mask& mask) {
    MACULA_CHECK_EQ(reference.size(), mask.size());
    MACULA_CHECK_EQ(test.size(), mask.size());
    const std::size_t count = countOf(mask);
    if (count == 0) return {};
    double sum = 0.0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (mask[i] != 0) sum += std::abs(double(test[i]) - double(reference[i]));
    }
    return sum / double(count);
}

Result<std::optional<double>> meanOf(std::span<const float> perPixel, const Mask& mask) {
    const auto fault = [](Text what) {
        return Error{
            ErrorCode::usage, std::move(what), {}, Text("Give a number for each pixel of the mask.")};
    };
    if (perPixel.size() != mask.size()) return fault(Text("Values and mask are not of one size."));
    if (std::any_of(perPixel.begin(), perPixel.end(), [](float v) { return !std::isfinite(v); }))
        return fault(Text("A value to average is no number."));
    const std::size_t count = countOf(mask);
    if (count == 0) return std::optional<double>();
    double sum = 0.0;
    for (std::size_t i = 0; i < mask.size(); ++i) sum += mask[i] != 0 ? double(perPixel[i]) : 0.0;
    return std::optional(sum / double(count));
}

double percentile(std::vector<double> values, double fraction) {
    MACULA_CHECK(!values.empty());
    std::sort(values.begin(), values.end());
    const double place = std::clamp(fraction, 0.0, 1.0) * double(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const double beyond = place - double(below);
    // Does not interpolate between equal neighbours or at an exact place: infinities would become NaN.
    if (beyond == 0.0 || values[below] == values[below + 1]) return values[below];
    return values[below] + beyond * (values[below + 1] - values[below]);
}

}  // namespace macula::image
