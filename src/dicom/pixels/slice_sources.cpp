#include "dicom/pixels/slice_sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace macula::dicom {

namespace {

constexpr double kSamePlace = 0.01;  // fraction of a slice distance

}  // namespace

UsableSlices withoutFrames(std::span<const SliceSource> slices, std::span<const double> places,
                           const std::vector<bool>& usable) {
    const std::size_t none = places.size();
    std::vector<std::size_t> good;  // ascending in place, as the frames are
    for (std::size_t f = 0; f < places.size(); ++f) {
        if (usable[f]) good.push_back(f);
    }
    const auto place = [&](std::size_t f) { return places[f]; };
    UsableSlices result;
    for (std::size_t k = 0; k < slices.size(); ++k) {
        SliceSource source = slices[k];
        if (!usable[source.below] || !usable[source.above]) {
            const double here = static_cast<double>(k);
            const auto below = std::ranges::upper_bound(good, here + kSamePlace, {}, place);
            const auto above = std::ranges::lower_bound(good, here - kSamePlace, {}, place);
            source = {.below = below == good.begin() ? none : *std::prev(below),
                      .above = above == good.end() ? none : *above,
                      .weight = 0.0};
            if (source.above == none || source.below == none) {
                if (result.slices.empty()) continue;  // a lost slice at the beginning
                break;                                // a lost slice at the end
            }
            if (places[source.below] >= places[source.above]) source.above = source.below;
            if (source.interpolated()) {
                source.weight = (here - places[source.below]) / (places[source.above] - places[source.below]);
            }
        }
        if (result.slices.empty()) result.first = k;
        result.slices.push_back(source);
    }
    return result;
}

std::vector<SliceRange> interpolatedRanges(std::span<const SliceSource> slices) {
    std::vector<SliceRange> ranges;
    for (std::size_t k = 0; k < slices.size(); ++k) {
        if (!slices[k].interpolated()) continue;
        const int slice = static_cast<int>(k);
        if (!ranges.empty() && ranges.back().last == slice - 1) {
            ranges.back().last = slice;
        } else {
            ranges.push_back({slice, slice});
        }
    }
    return ranges;
}

std::string describe(std::span<const SliceRange> ranges) {
    std::string list;
    for (const SliceRange& range : ranges) {
        if (list.size() > 100) return list + ", …";
        list += fmt::format("{}{}", list.empty() ? "" : ", ", range.first + 1);
        if (range.last > range.first) list += fmt::format("-{}", range.last + 1);
    }
    return list;
}

void blend(std::span<const std::uint16_t> below, std::span<const std::uint16_t> above, double weight,
           const std::optional<StoredRange>& padding, std::span<std::uint16_t> result) {
    const std::span<const std::uint16_t> nearer = weight < 0.5 ? below : above;
    for (std::size_t i = 0; i < result.size(); ++i) {
        const bool isPadding = padding && (padding->contains(below[i]) || padding->contains(above[i]));
        const auto mixed =
            static_cast<std::uint16_t>(std::lround((1.0 - weight) * below[i] + weight * above[i]));
        // An interpolated value may happen to equal the padding value: then takes the nearer one.
        result[i] = isPadding || (padding && padding->contains(mixed)) ? nearer[i] : mixed;
    }
}

void blend(std::span<const float> below, std::span<const float> above, double weight,
           std::span<float> result) {
    const std::span<const float> nearer = weight < 0.5 ? below : above;
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double mixed = (1.0 - weight) * double{below[i]} + weight * double{above[i]};
        result[i] = std::isnan(mixed) ? nearer[i] : static_cast<float>(mixed);
    }
}

}  // namespace macula::dicom
