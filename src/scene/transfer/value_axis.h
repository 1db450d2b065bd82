// The axis of values of a plot: its range, and the pixel of each value.
#pragma once

#include <optional>
#include <vector>

#include "base/volume.h"
#include "pipeline/volume/volume_fit.h"

namespace macula::scene {

// Maps the values of a preset to those of a volume, and back; the identity without a fit.
struct ValueMap {
    double scale = 1.0;  // above 0
    double offset = 0.0;

    static ValueMap of(const std::optional<VolumeFit>& fit);
    double shownFrom(double preset) const { return offset + scale * preset; }
    double presetFrom(double shown) const { return (shown - offset) / scale; }
};

// Pixels are logical, from the left end. The range is never empty, and within 4e9 of 0.
struct ValueAxis {
    ValueRange shown{0.0, 1.0};  // in units of the volume
    double lengthPx = 1.0;

    // `range` with some room at either end.
    static ValueAxis over(const ValueRange& range, double lengthPx);

    double unitsPerPx() const { return (shown.high - shown.low) / lengthPx; }
    double pxOf(double value) const { return (value - shown.low) / unitsPerPx(); }
    double valueAt(double px) const { return shown.low + px * unitsPerPx(); }
    bool contains(double value) const { return shown.low <= value && value <= shown.high; }

    // Keeps `about` at its pixel. A factor above 1 shows more. Arguments that are not finite change nothing.
    ValueAxis zoomed(double factor, double about) const;
    ValueAxis panned(double byUnits) const;

    // The distance of ticks: 1, 2 or 5 times a power of ten, at least `leastPx` apart.
    double tickStep(double leastPx) const;
    std::vector<double> ticks(double leastPx) const;
};

}  // namespace macula::scene
