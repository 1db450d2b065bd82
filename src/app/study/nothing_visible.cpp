#include "app/study/nothing_visible.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "app/frame/projection_windows.h"
#include "pipeline/volume/transfer_function.h"
#include "pipeline/volume/volume_fit.h"
#include "presets/catalogue.h"

namespace macula::app {

namespace {

// "Nothing is visible in the picture. The series has values from …": of a volume that has some.
std::string nothingOf(const Volume& volume, const ValueRange& range) {
    const std::string unit = volume.unitName().empty() ? "" : " " + volume.unitName();
    return fmt::format("Nothing is visible in the picture. The series has values from {:g} to {:g}{}.",
                       range.low, range.high, unit);
}

constexpr const char* kAllIsPadding = "Nothing is visible: every voxel of the series is padding.";

// Counts of stored values over a share of the voxels: evenly taken, and enough for a thousandth of them to be
// found.
std::map<std::uint16_t, std::size_t> countsOf(const Volume& volume) {
    const auto voxels = volume.voxels();
    const auto& padding = volume.padding();
    const std::size_t step = std::max<std::size_t>(voxels.size() / 1'000'000, 1) | 1u;
    std::map<std::uint16_t, std::size_t> counts;
    for (std::size_t i = 0; i < voxels.size(); i += step) {
        const std::uint16_t stored = voxels[i];
        if (!padding || stored < padding->low || stored > padding->high) ++counts[stored];
    }
    return counts;
}

// Whether a thousandth of the voxels holds matter of which a hand's breadth would be visible.
bool shows(const TransferFunction& preset, const Volume& volume,
           const std::map<std::uint16_t, std::size_t>& counts) {
    constexpr double kLeastOpacity = 0.01;
    const TransferFunction function = fitted(preset, volume);
    const UnitsFromStored& map = volume.unitsFromStored();
    std::size_t all = 0;
    std::size_t seen = 0;
    for (const auto& [stored, count] : counts) {
        all += count;
        if (opacityAt(function, map.slope * stored + map.intercept) >= kLeastOpacity) seen += count;
    }
    return seen * 1000 > all;
}

}  // namespace

std::string whyNothingIsVisible(const Volume& volume) {
    const auto& range = volume.valueRange();
    if (!range) return kAllIsPadding;
    std::string sentence = nothingOf(volume, *range);
    const auto presets = presets::builtInPresets();
    if (!presets) return sentence;
    const auto counts = countsOf(volume);
    std::vector<std::string> names;
    for (const TransferFunction& preset : *presets) {
        if (suits(preset, volume.unit()) && shows(preset, volume, counts)) names.push_back(preset.name);
    }
    constexpr std::size_t kMostNames = 6;
    if (names.size() > kMostNames) names.resize(kMostNames);
    if (names.empty()) return sentence + " No built-in preset would show any of them.";
    return sentence + fmt::format(" Presets that show some of them: {}.", fmt::join(names, ", ")) +
           " Check the camera and the clip too.";
}

std::string whyNothingIsVisible(const Volume& volume, const DisplayWindow& window) {
    const auto& range = volume.valueRange();
    if (!range) return kAllIsPadding;
    return nothingOf(volume, *range) +
           fmt::format(
               " It is seen through the window {}: choose another one. Check the camera and the clip too.",
               windowText(window, volume.unitName()));
}

}  // namespace macula::app
