#include "scene/drawing/nothing_visible.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "pipeline/volume/transfer_function.h"
#include "presets/catalogue.h"
#include "presets/seen_values.h"
#include "scene/drawing/projection_windows.h"

namespace macula::scene {

namespace {

// "Nothing is visible in the picture. The series has values from …": of a volume that has some.
std::string nothingOf(const Volume& volume, const ValueRange& range) {
    const std::string unit = volume.unitName().empty() ? "" : " " + volume.unitName();
    return fmt::format("Nothing is visible in the picture. The series has values from {:g} to {:g}{}.",
                       range.low, range.high, unit);
}

constexpr const char* kAllIsPadding = "Nothing is visible: every voxel of the series is padding.";

}  // namespace

std::string whyNothingIsVisible(const Volume& volume) {
    const auto& range = volume.valueRange();
    if (!range) return kAllIsPadding;
    std::string sentence = nothingOf(volume, *range);
    const auto presets = presets::builtInPresets();
    if (!presets) return sentence;
    const presets::SeenValues values(volume);
    std::vector<std::string> names;
    for (const TransferFunction& preset : *presets) {
        if (suits(preset, volume.unit()) && values.areSeenWith(preset)) names.push_back(preset.name);
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

}  // namespace macula::scene
