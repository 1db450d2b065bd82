#include "scene/transfer/value_axis.h"

#include <algorithm>
#include <cmath>

namespace macula::scene {

namespace {

constexpr double kFarthest = 2e9;     // farther than any value that a preset may have
constexpr double kNarrowest = 1e-6;   // the narrowest range, in units,
constexpr double kResolution = 1e-9;  // and relative to its values
constexpr double kRoom = 0.03;        // at either end, as a fraction of the range
constexpr std::size_t kMostTicks = 1000;

// The range around the same middle, wide enough for double precision.
ValueRange usable(const ValueRange& range) {
    const double middle = std::clamp(range.low + 0.5 * (range.high - range.low), -kFarthest, kFarthest);
    const double least = std::max(kNarrowest, kResolution * std::abs(middle));
    const double half = 0.5 * std::clamp(range.high - range.low, least, 2.0 * kFarthest);
    return {middle - half, middle + half};
}

}  // namespace

ValueMap ValueMap::of(const std::optional<VolumeFit>& fit) {
    if (!fit) return {};
    return {.scale = fit->scale(), .offset = fit->volume.low - fit->preset.low * fit->scale()};
}

ValueAxis ValueAxis::over(const ValueRange& range, double lengthPx) {
    const double room = kRoom * (range.high - range.low);
    const double length = std::max(1.0, lengthPx);
    // A single value gets a range of 1 around it.
    if (!(range.low < range.high))
        return {.shown = usable({range.low - 0.5, range.low + 0.5}), .lengthPx = length};
    return {.shown = usable({range.low - room, range.high + room}), .lengthPx = length};
}

ValueAxis ValueAxis::zoomed(double factor, double about) const {
    if (!std::isfinite(factor) || !(factor > 0.0) || !std::isfinite(about)) return *this;
    const double wide = shown.high - shown.low;
    const double least = std::max(kNarrowest, kResolution * std::abs(about));
    // Clamped before the ends are computed: otherwise a zoom beyond the limits would move the middle.
    factor = std::clamp(factor, std::min(1.0, least / wide), std::max(1.0, 2.0 * kFarthest / wide));
    return {.shown = usable({about + factor * (shown.low - about), about + factor * (shown.high - about)}),
            .lengthPx = lengthPx};
}

ValueAxis ValueAxis::panned(double byUnits) const {
    if (!std::isfinite(byUnits)) return *this;
    return {.shown = usable({shown.low + byUnits, shown.high + byUnits}), .lengthPx = lengthPx};
}

double ValueAxis::tickStep(double leastPx) const {
    const double least = std::max(1.0, leastPx) * unitsPerPx();
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double times : {1.0, 2.0, 5.0}) {
        if (times * power >= least) return times * power;
    }
    return 10.0 * power;
}

std::vector<double> ValueAxis::ticks(double leastPx) const {
    std::vector<double> values;
    const double step = tickStep(leastPx);
    for (double i = std::ceil(shown.low / step); i * step <= shown.high && values.size() < kMostTicks; ++i)
        values.push_back(i * step);
    return values;
}

}  // namespace macula::scene
