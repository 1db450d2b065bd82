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

// "Nothing is visible in the picture. The series has values from …", for a volume that has values.
Text nothingOf(const Volume& volume, const ValueRange& range) {
    const std::string unit = volume.unitName().empty() ? "" : " " + volume.unitName();
    return Text("Nothing is visible in the picture. The series has values from {:g} to {:g}{}.", range.low,
                range.high, unit);
}

Text allIsPadding() {
    return Text("Nothing is visible: every voxel of the series is padding.");
}

}  // namespace

Text whyNothingIsVisible(const Volume& volume) {
    const auto& range = volume.valueRange();
    if (!range) return allIsPadding();
    Text sentence = nothingOf(volume, *range);
    const auto presets = presets::builtInPresets();
    if (!presets) return sentence;
    const presets::SeenValues values(volume);
    std::vector<std::string> names;
    for (const TransferFunction& preset : *presets) {
        if (suits(preset, volume.unit()) && values.areSeenWith(preset)) names.push_back(preset.name);
    }
    constexpr std::size_t kMostNames = 6;
    if (names.size() > kMostNames) names.resize(kMostNames);
    if (names.empty())
        return Text::joined({std::move(sentence), Text("No built-in preset would show any of them.")}, " ");
    return Text::joined(
        {std::move(sentence),
         Text("Presets that show some of them: {}.", fmt::format("{}", fmt::join(names, ", "))),
         Text("Check the camera and the clip too.")},
        " ");
}

Text whyNothingIsVisible(const Volume& volume, const DisplayWindow& window) {
    const auto& range = volume.valueRange();
    if (!range) return allIsPadding();
    return Text::joined(
        {nothingOf(volume, *range),
         Text("It is seen through the window {}: choose another one.", windowText(window, volume.unitName())),
         Text("Check the camera and the clip too.")},
        " ");
}

}  // namespace macula::scene
