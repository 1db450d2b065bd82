// Whether 16 bits hold the values of all slices, and with which map.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "dicom/stack/intensity.h"

namespace macula::dicom {

namespace {

constexpr int kSignedOffset = 32768;
constexpr double kLargestStored = 65535.0;
// The limit on the common steps in one slope. Beyond it 16 bits hold at most 16 different values of that
// slice: so fine a step comes from the decimal digits of the slopes, not from the data.
constexpr double kMostStepsOfASlope = 4096.0;
constexpr double kLargestShift = 1e12;  // far from where integers are no longer exact

// The offset that unpacking adds to the raw values of narrow cells; wide cells are not packed.
int offsetOf(const CellFormat& format) {
    return format.isSigned && isNarrow(format) ? kSignedOffset : 0;
}

// value = slope * x + intercept, where x is the unpacked value, or what the modality LUT makes of it.
struct Line {
    double slope;
    double intercept;
};

Line lineOf(const SliceIntensity& slice) {
    if (slice.modalityLut) return {1.0, 0.0};
    return {slice.slope, slice.intercept - slice.slope * offsetOf(slice.format)};
}

bool isNearlyInteger(double value) {
    return std::abs(value - std::round(value)) <= 1e-9 * std::max(1.0, std::abs(value));
}

// The greatest common divisor by Euclid's algorithm, for numbers that were written in decimal digits.
double greatestCommonDivisor(double a, double b) {
    const double negligible = 1e-9 * std::max(a, b);
    while (b > negligible) {
        const double rest = std::abs(a - std::round(a / b) * b);
        a = b;
        b = rest;
    }
    return a;
}

// The step that all slices' maps are multiples of, if there is one.
std::optional<double> commonStep(std::span<const Line> lines) {
    double step = std::abs(lines[0].slope);
    double steepest = 0.0;
    for (const Line& line : lines) {
        step = greatestCommonDivisor(step, std::abs(line.slope));
        step = greatestCommonDivisor(step, std::abs(line.intercept - lines[0].intercept));
        steepest = std::max(steepest, std::abs(line.slope));
        if (!(step * kMostStepsOfASlope >= steepest)) return {};
    }
    if (!std::isfinite(step)) return {};
    step = steepest / std::round(steepest / step);  // removes accumulated rounding errors
    for (const Line& line : lines) {
        if (!isNearlyInteger(line.slope / step) || std::round(line.slope / step) == 0.0) return {};
        if (!isNearlyInteger((line.intercept - lines[0].intercept) / step)) return {};
    }
    return step;
}

// The unpacked values that the stored bits can hold.
StoredRange formatRange(const CellFormat& format) {
    const int low = format.isSigned ? kSignedOffset - (1 << (format.bitsStored - 1)) : 0;
    return {static_cast<std::uint16_t>(low), static_cast<std::uint16_t>(low + (1 << format.bitsStored) - 1)};
}

// The range of values that the stored bits can hold.
ValueRange valueRange(const SliceIntensity& slice, const Line& line) {
    const StoredRange unpacked = formatRange(slice.format);
    ValueRange x{double(unpacked.low), double(unpacked.high)};
    if (slice.modalityLut) {
        const auto [least, most] = std::ranges::minmax(slice.modalityLut->entries);
        x = {double(least), double(most)};
    }
    const double a = line.slope * x.low + line.intercept;
    const double b = line.slope * x.high + line.intercept;
    return {std::min(a, b), std::max(a, b)};
}

// The plan for 16 bits with this step, if they are enough.
std::optional<IntensityPlan> planWithStep(std::span<const SliceIntensity> slices, std::span<const Line> lines,
                                          double step) {
    ValueRange all{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
    bool hasPadding = false;
    for (std::size_t k = 0; k < slices.size(); ++k) {
        hasPadding = hasPadding || slices[k].padding.has_value();
        const ValueRange range = valueRange(slices[k], lines[k]);
        all = {std::min(all.low, range.low), std::max(all.high, range.high)};
    }
    // Reserves stored 0 for padding, because the slices' own padding values need not lie in one place in
    // units.
    const double first = hasPadding ? 1.0 : 0.0;
    if (!(std::round((all.high - all.low) / step) <= kLargestStored - first)) return {};

    IntensityPlan plan;
    const double steps = std::round((all.low - lines[0].intercept) / step);
    plan.unitsFromStored = {step, lines[0].intercept + (steps - first) * step};
    if (hasPadding) plan.padding = StoredRange{0, 0};
    for (std::size_t k = 0; k < slices.size(); ++k) {
        const double shift = std::round((lines[k].intercept - plan.unitsFromStored.intercept) / step);
        if (!(std::abs(shift) < kLargestShift)) return {};
        plan.slices.push_back({.kind = SliceMap::Kind::linear,
                               .scale = std::llround(lines[k].slope / step),
                               .shift = static_cast<std::int64_t>(shift),
                               .padding = unpackedPadding(slices[k]),
                               .modalityLut = slices[k].modalityLut,
                               .lutOffset = offsetOf(slices[k].format)});
    }
    return plan;
}

// Whether all slices have one linear map and one padding.
bool isUniform(std::span<const SliceIntensity> slices) {
    return std::ranges::all_of(slices, [&](const SliceIntensity& slice) {
        return !slice.modalityLut && slice.format.isSigned == slices[0].format.isSigned &&
               slice.slope == slices[0].slope && slice.intercept == slices[0].intercept &&
               slice.padding == slices[0].padding;
    });
}

IntensityPlan uniformPlan(std::span<const SliceIntensity> slices) {
    IntensityPlan plan;
    plan.padding = unpackedPadding(slices[0]);
    const Line line = lineOf(slices[0]);
    if (line.slope > 0.0) {
        plan.unitsFromStored = {line.slope, line.intercept};
        plan.slices.assign(slices.size(), {});
        return plan;
    }
    // A Volume's slope is positive: store 65535 - unpacked instead, which loses nothing.
    plan.unitsFromStored = {-line.slope, line.intercept + line.slope * kLargestStored};
    plan.slices.assign(slices.size(), {.kind = SliceMap::Kind::invert});
    if (plan.padding) {
        plan.padding = StoredRange{static_cast<std::uint16_t>(65535 - plan.padding->high),
                                   static_cast<std::uint16_t>(65535 - plan.padding->low)};
    }
    return plan;
}

}  // namespace

IntensityPlan planFromFormats(std::span<const SliceIntensity> slices) {
    IntensityPlan inFloat{.format = VoxelFormat::float32};
    const bool narrow = std::ranges::all_of(slices, isNarrow, &SliceIntensity::format);
    if (narrow && isUniform(slices)) return uniformPlan(slices);
    if (std::ranges::any_of(slices, [](const auto& s) { return s.format.kind != CellKind::integer; }))
        return inFloat;
    std::vector<Line> lines;
    for (const SliceIntensity& slice : slices) lines.push_back(lineOf(slice));
    const std::optional<double> step = commonStep(lines);
    if (!step) return inFloat;
    if (narrow) {
        if (auto plan = planWithStep(slices, lines, *step)) return *plan;
    }
    inFloat.steps = UnitsFromStored{*step, lines[0].intercept};
    return inFloat;
}

namespace {

struct Extent {
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    bool hasPadding = false;
};

Extent extentOf(std::span<const float> values) {
    Extent extent;
    for (const float value : values) {
        if (std::isnan(value)) {
            extent.hasPadding = true;
        } else {
            extent.low = std::min<double>(extent.low, value);
            extent.high = std::max<double>(extent.high, value);
        }
    }
    return extent;
}

// Narrows values to 16 bits. False unless each of them stays the same.
bool narrow(std::span<const float> values, const UnitsFromStored& unitsFromStored, double first,
            std::span<std::uint16_t> result) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isnan(values[i])) continue;  // 0 is there already
        const double stored =
            std::round((double{values[i]} - unitsFromStored.intercept) / unitsFromStored.slope);
        if (!(stored >= first && stored <= kLargestStored)) return false;
        if (static_cast<float>(unitsFromStored(stored)) != values[i]) return false;
        result[i] = static_cast<std::uint16_t>(stored);
    }
    return true;
}

}  // namespace

std::optional<NarrowedVoxels> narrowed(std::span<const float> values, const UnitsFromStored& steps,
                                       const CancelToken& cancel) {
    constexpr std::size_t kPortion = std::size_t{1} << 20;
    const std::size_t portions = (values.size() + kPortion - 1) / kPortion;
    const auto portion = [&](auto all, std::size_t i) {
        return all.subspan(i * kPortion, std::min(kPortion, all.size() - i * kPortion));
    };
    std::vector<Extent> extents(portions);
    parallelFor(
        portions, [&](std::size_t i) { extents[i] = extentOf(portion(values, i)); }, cancel);
    Extent extent;
    for (const Extent& part : extents) {
        extent = {std::min(extent.low, part.low), std::max(extent.high, part.high),
                  extent.hasPadding || part.hasPadding};
    }
    if (extent.low > extent.high) extent.low = extent.high = steps.intercept;
    // If a step is finer than float resolves, values have been rounded already, and 16 bits would only look
    // exact.
    constexpr double kWholeNumbersOfFloat = 1 << 24;
    if (std::max(std::abs(extent.low), std::abs(extent.high)) > kWholeNumbersOfFloat * steps.slope) return {};
    const double first = extent.hasPadding ? 1.0 : 0.0;
    if (!(std::round((extent.high - extent.low) / steps.slope) <= kLargestStored - first)) return {};

    NarrowedVoxels result;
    const double low = std::round((extent.low - steps.intercept) / steps.slope);
    result.unitsFromStored = {steps.slope, steps.intercept + (low - first) * steps.slope};
    if (extent.hasPadding) result.padding = StoredRange{0, 0};
    result.voxels.resize(values.size());
    std::atomic<bool> exact{true};
    parallelFor(
        portions,
        [&](std::size_t i) {
            if (exact && !narrow(portion(values, i), result.unitsFromStored, first,
                                 portion(std::span(result.voxels), i)))
                exact = false;
        },
        cancel);
    if (!exact || cancel.cancelled()) return {};
    return result;
}

}  // namespace macula::dicom
