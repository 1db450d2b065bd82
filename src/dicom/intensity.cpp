#include "dicom/intensity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace macula::dicom {

namespace {

constexpr int kSignedOffset = 32768;
constexpr double kLargestStored = 65535.0;

int offsetOf(const CellFormat& format) {
    return format.isSigned ? kSignedOffset : 0;
}

// value = slope * unpacked + intercept.
struct Line {
    double slope;
    double intercept;
};

Line lineOf(const SliceIntensity& slice) {
    return {slice.slope, slice.intercept - slice.slope * offsetOf(slice.format)};
}

bool isNearlyInteger(double value) {
    return std::abs(value - std::round(value)) <= 1e-9 * std::max(1.0, std::abs(value));
}

// The step that all slices' maps are multiples of, if there is an obvious one: the smallest slope.
std::optional<double> commonStep(std::span<const Line> lines) {
    double step = std::numeric_limits<double>::max();
    for (const Line& line : lines) step = std::min(step, std::abs(line.slope));
    for (const Line& line : lines) {
        if (!isNearlyInteger(line.slope / step)) return {};
        if (!isNearlyInteger((line.intercept - lines[0].intercept) / step)) return {};
    }
    return step;
}

// The one padding range of all slices, with what had to be assumed about it.
std::optional<RawRange> commonPadding(std::span<const SliceIntensity> slices,
                                      std::vector<std::string>& assumptions) {
    std::optional<RawRange> padding;
    std::size_t missing = 0;
    for (const SliceIntensity& slice : slices) {
        if (!slice.padding) {
            ++missing;
        } else if (!padding) {
            padding = slice.padding;
        } else if (*padding != *slice.padding) {
            assumptions.push_back(
                "The slices declare different padding values; no voxel was taken for padding, and all are "
                "drawn.");
            return {};
        }
    }
    if (padding && missing > 0) {
        assumptions.push_back(
            fmt::format("{} of {} slices declare no padding value; that of the others was taken for them.",
                        missing, slices.size()));
    }
    return padding;
}

}  // namespace

bool isUsable(const CellFormat& format) {
    return (format.bitsAllocated == 8 || format.bitsAllocated == 16) && format.bitsStored >= 1 &&
           format.highBit < format.bitsAllocated && format.highBit + 1 >= format.bitsStored;
}

RawRange paddingRange(const CellFormat& format, std::uint16_t valueWord,
                      std::optional<std::uint16_t> limitWord) {
    const auto raw = [&](std::uint16_t word) {
        return format.isSigned ? static_cast<int>(static_cast<std::int16_t>(word)) : static_cast<int>(word);
    };
    const int value = raw(valueWord);
    const int limit = limitWord ? raw(*limitWord) : value;
    return {std::min(value, limit), std::max(value, limit)};
}

void unpackCells(const CellFormat& format, std::span<std::uint16_t> cells) {
    const int unusedBelow = format.highBit + 1 - format.bitsStored;
    if (format.isSigned) {
        // The stored bits go to the top of the word, so that its arithmetic shift extends the sign.
        const int up = 15 - format.highBit;
        const int down = 16 - format.bitsStored;
        for (std::uint16_t& cell : cells) {
            const auto top = static_cast<std::int16_t>(static_cast<std::uint16_t>(cell << up));
            cell = static_cast<std::uint16_t>((top >> down) + kSignedOffset);
        }
    } else if (format.bitsStored < 16) {
        const unsigned mask = (1u << format.bitsStored) - 1;
        for (std::uint16_t& cell : cells) cell = static_cast<std::uint16_t>((cell >> unusedBelow) & mask);
    }
}

void applyMap(const SliceMap& map, std::span<std::uint16_t> unpacked) {
    switch (map.kind) {
        case SliceMap::Kind::keep:
            return;
        case SliceMap::Kind::invert:
            for (std::uint16_t& voxel : unpacked) voxel = static_cast<std::uint16_t>(65535 - voxel);
            return;
        case SliceMap::Kind::linear:
            for (std::uint16_t& voxel : unpacked) {
                const bool isPadding = map.padding && map.padding->contains(voxel);
                const double stored = isPadding ? 0.0 : std::round(map.scale * voxel + map.shift);
                voxel = static_cast<std::uint16_t>(std::clamp(stored, 0.0, kLargestStored));
            }
            return;
    }
}

std::optional<StoredRange> unpackedPadding(const SliceIntensity& slice) {
    if (!slice.padding) return {};
    const int low = slice.format.isSigned ? -(1 << (slice.format.bitsStored - 1)) : 0;
    const int high = (1 << (slice.format.bitsStored - (slice.format.isSigned ? 1 : 0))) - 1;
    if (slice.padding->high < low || slice.padding->low > high) return {};
    const int offset = offsetOf(slice.format);
    return StoredRange{static_cast<std::uint16_t>(std::max(slice.padding->low, low) + offset),
                       static_cast<std::uint16_t>(std::min(slice.padding->high, high) + offset)};
}

bool isUniform(std::span<const SliceIntensity> slices) {
    return std::all_of(slices.begin(), slices.end(), [&](const SliceIntensity& slice) {
        return slice.format.isSigned == slices[0].format.isSigned && slice.slope == slices[0].slope &&
               slice.intercept == slices[0].intercept;
    });
}

IntensityPlan uniformPlan(std::span<const SliceIntensity> slices) {
    IntensityPlan plan;
    SliceIntensity common = slices[0];
    common.padding = commonPadding(slices, plan.assumptions);
    for (const SliceIntensity& slice : slices) {
        common.format.bitsStored = std::max(common.format.bitsStored, slice.format.bitsStored);
    }
    plan.padding = unpackedPadding(common);
    if (common.padding && !plan.padding) {
        plan.assumptions.push_back(
            "The declared padding value lies outside what the stored bits can hold; no voxel was taken for "
            "padding.");
    }
    const Line line = lineOf(common);
    if (line.slope > 0.0) {
        plan.unitsFromStored = {line.slope, line.intercept};
        plan.slices.assign(slices.size(), {});
        return plan;
    }
    // A Volume's slope is positive: store 65535 - unpacked instead, which loses nothing.
    plan.unitsFromStored = {-line.slope, line.intercept + line.slope * kLargestStored};
    plan.slices.assign(slices.size(),
                       {.kind = SliceMap::Kind::invert, .scale = 1.0, .shift = 0.0, .padding = {}});
    if (plan.padding) {
        plan.padding = StoredRange{static_cast<std::uint16_t>(65535 - plan.padding->high),
                                   static_cast<std::uint16_t>(65535 - plan.padding->low)};
    }
    return plan;
}

IntensityPlan mixedPlan(std::span<const SliceIntensity> slices, std::span<const StoredRange> unpackedRanges) {
    std::vector<Line> lines;
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    bool hasPadding = false;
    for (std::size_t k = 0; k < slices.size(); ++k) {
        lines.push_back(lineOf(slices[k]));
        hasPadding = hasPadding || unpackedPadding(slices[k]).has_value();
        if (unpackedRanges[k].low > unpackedRanges[k].high) continue;  // all padding
        for (const double unpacked : {double(unpackedRanges[k].low), double(unpackedRanges[k].high)}) {
            const double value = lines[k].slope * unpacked + lines[k].intercept;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    if (low > high) low = high = 0.0;

    IntensityPlan plan;
    UnitsFromStored& map = plan.unitsFromStored;
    // Stored 0 is kept for padding, because the slices' own padding values need not lie in one place in
    // units.
    const double first = hasPadding ? 1.0 : 0.0;
    const std::optional<double> step = commonStep(lines);
    if (step && (high - low) / *step <= kLargestStored - first) {
        map.slope = *step;
        const double steps = std::round((low - lines[0].intercept) / *step);
        map.intercept = lines[0].intercept + (steps - first) * *step;
    } else {
        map.slope = high > low ? (high - low) / (kLargestStored - first) : 1.0;
        map.intercept = low - first * map.slope;
        plan.assumptions.push_back(fmt::format(
            "The slices have different rescale factors; their values were brought to one 16-bit scale, "
            "with an error of at most {:.3g}.",
            0.5 * map.slope));
    }
    if (hasPadding) {
        plan.padding = StoredRange{0, 0};
        plan.assumptions.push_back(
            "The slices have different rescale factors; padding was given one common value below all "
            "others.");
    }
    for (std::size_t k = 0; k < slices.size(); ++k) {
        plan.slices.push_back({.kind = SliceMap::Kind::linear,
                               .scale = lines[k].slope / map.slope,
                               .shift = (lines[k].intercept - map.intercept) / map.slope,
                               .padding = unpackedPadding(slices[k])});
    }
    return plan;
}

}  // namespace macula::dicom
