#include "presets/seen_values.h"

#include <algorithm>
#include <cstddef>

#include "pipeline/volume/volume_fit.h"

namespace macula::presets {

SeenValues::SeenValues(const Volume& volume) : volume_(volume), counts_(65536, 0) {
    constexpr std::size_t kMostLookedAt = 1'000'000;
    const auto voxels = volume.voxels();
    const std::size_t step = std::max<std::size_t>(voxels.size() / kMostLookedAt, 1) | 1U;
    for (std::size_t i = 0; i < voxels.size(); i += step) {
        if (volume.padding() && volume.padding()->contains(voxels[i])) continue;
        ++counts_[voxels[i]];
        ++all_;
    }
}

bool SeenValues::areSeenWith(const TransferFunction& preset) const {
    constexpr double kLeastOpacity = 0.01;
    constexpr std::uint64_t kOneOf = 1000;
    const TransferFunction function = fitted(preset, volume_);
    const TransferFunction steep = withCurvesSwapped(function);
    const auto seenAs = [&](double value) {
        const double opacity = opacityAt(function, value);
        return usesSteepCurves(function) ? std::max(opacity, opacityAt(steep, value)) : opacity;
    };
    std::uint64_t seen = 0;
    for (std::size_t stored = 0; stored < counts_.size(); ++stored) {
        if (counts_[stored] == 0) continue;
        if (seenAs(volume_.unitsFromStored()(double(stored))) >= kLeastOpacity) seen += counts_[stored];
    }
    return seen * kOneOf > all_;
}

}  // namespace macula::presets
