#include "image/edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/check.h"
#include "image/frame_metrics.h"
#include "image/planes.h"

namespace macula::image {

namespace {

constexpr double kMostFraction = 0.999;

Result<void> fits(const Mask& mask, const Image& image) {
    if (mask.size() == std::size_t(image.width) * std::size_t(image.height)) return {};
    return Error{ErrorCode::usage,
                 Text("The mask does not fit the pictures."),
                 {},
                 Text("Give one number for each pixel.")};
}

// Combines the values of a pixel and of its neighbours within the picture.
template <typename Combined>
double around(const Plane& plane, int x, int y, double first, const Combined& combined) {
    double value = first;
    for (int toY = std::max(y - 1, 0); toY <= std::min(y + 1, plane.height - 1); ++toY) {
        for (int toX = std::max(x - 1, 0); toX <= std::min(x + 1, plane.width - 1); ++toX)
            value = combined(value, plane.at(toX, toY));
    }
    return value;
}

double stepAt(const Plane& plane, int x, int y) {
    const double here = plane.at(x, y);
    double step = 0.0;
    const auto look = [&](int toX, int toY) {
        if (toX < 0 || toY < 0 || toX >= plane.width || toY >= plane.height) return;
        step = std::max(step, std::abs(plane.at(toX, toY) - here));
    };
    look(x - 1, y);
    look(x + 1, y);
    look(x, y - 1);
    look(x, y + 1);
    return step;
}

LuminanceSteps stepsOf(const Plane& plane, const Mask& mask) {
    std::vector<double> steps;
    double sum = 0.0;
    for (int y = 0; y < plane.height; ++y) {
        for (int x = 0; x < plane.width; ++x) {
            if (mask[std::size_t(y) * std::size_t(plane.width) + std::size_t(x)] == 0) continue;
            steps.push_back(stepAt(plane, x, y));
            sum += steps.back();
        }
    }
    return {.mean = sum / double(steps.size()), .most = percentile(std::move(steps), kMostFraction)};
}

double ratioOf(double frame, double reference) {
    return std::max(frame, SeamVisibility::kLeast) / std::max(reference, SeamVisibility::kLeast);
}

}  // namespace

Mask silhouetteMask(std::span<const float> coverage, int width, int height) {
    MACULA_CHECK_EQ(coverage.size(), std::size_t(width) * std::size_t(height));
    Plane covers(width, height);
    std::transform(coverage.begin(), coverage.end(), covers.values.begin(),
                   [](float c) { return c >= 0.5f ? 1.0 : 0.0; });
    Mask mask(coverage.size(), 0);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double least = around(covers, x, y, 1.0, [](double a, double b) { return std::min(a, b); });
            const double most = around(covers, x, y, 0.0, [](double a, double b) { return std::max(a, b); });
            mask[std::size_t(y) * std::size_t(width) + std::size_t(x)] = least != most ? 1 : 0;
        }
    }
    return mask;
}

Mask mixedMask(std::span<const float> weights) {
    Mask mask(weights.size(), 0);
    std::transform(weights.begin(), weights.end(), mask.begin(), [](float w) {
        return double(w) > kOuterWeight && double(w) < kInnerWeight ? std::uint8_t(1) : std::uint8_t(0);
    });
    return mask;
}

double EdgeVisibility::meanRatio() const {
    return ratioOf(frame.mean, reference.mean);
}

double EdgeVisibility::mostRatio() const {
    return ratioOf(frame.most, reference.most);
}

Result<std::optional<EdgeVisibility>> edgeVisibility(const Image& reference, const Image& frame,
                                                     const Mask& mask) {
    MACULA_TRY_VOID(comparable(reference, frame));
    MACULA_TRY_VOID(fits(mask, frame));
    if (std::all_of(mask.begin(), mask.end(), [](std::uint8_t m) { return m == 0; }))
        return std::optional<EdgeVisibility>();
    return std::optional(EdgeVisibility{.frame = stepsOf(luminanceOf(frame), mask),
                                        .reference = stepsOf(luminanceOf(reference), mask)});
}

Result<std::size_t> darkerThanBoth(const Image& frame, const Image& a, const Image& b, const Mask& mask,
                                   double margin) {
    MACULA_TRY_VOID(comparable(a, frame));
    MACULA_TRY_VOID(comparable(b, frame));
    MACULA_TRY_VOID(fits(mask, frame));
    const Plane shown = luminanceOf(frame);
    const std::array sources{luminanceOf(a), luminanceOf(b)};
    std::size_t darker = 0;
    for (int y = 0; y < shown.height; ++y) {
        for (int x = 0; x < shown.width; ++x) {
            if (mask[std::size_t(y) * std::size_t(shown.width) + std::size_t(x)] == 0) continue;
            double least = 1.0;
            for (const Plane& source : sources)
                least = around(source, x, y, least, [](double p, double q) { return std::min(p, q); });
            if (shown.at(x, y) < least - margin) ++darker;
        }
    }
    return darker;
}

}  // namespace macula::image
