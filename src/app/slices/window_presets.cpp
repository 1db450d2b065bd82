#include "app/slices/window_presets.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "pipeline/volume/window.h"

namespace macula::app {

namespace {

constexpr int kAllValues = 9;

// Width and level in HU. Soft tissue, lung, brain and angiography are the presets of the OHIF viewer; bone,
// liver and mediastinum are those of Radiopaedia, "Windowing (CT)".
struct CtPreset {
    int digit;
    const char* name;
    double widthHu;
    double levelHu;
};
constexpr CtPreset kCtPresets[] = {{2, "Soft tissue", 400.0, 40.0}, {3, "Lung", 1500.0, -600.0},
                                   {4, "Bone", 1800.0, 400.0},      {5, "Brain", 80.0, 40.0},
                                   {6, "Liver", 150.0, 30.0},       {7, "Mediastinum", 350.0, 50.0},
                                   {8, "Angiography", 600.0, 300.0}};

}  // namespace

std::vector<WindowPreset> windowPresets(const Volume& volume) {
    std::vector<WindowPreset> presets{{.digit = 1, .name = "Of the series"}};
    if (volume.unit() == Unit::hounsfield) {
        for (const CtPreset& ct : kCtPresets)
            presets.push_back(
                {.digit = ct.digit,
                 .name = ct.name,
                 .window = DisplayWindow{
                     .center = ct.levelHu, .width = ct.widthHu, .explanation = {}, .function = {}}});
    } else {
        const std::vector<DisplayWindow>& windows = volume.windows();
        const std::size_t most = std::min<std::size_t>(windows.size(), kAllValues - 1);
        for (std::size_t i = 1; i < most; ++i) {
            const std::string& named = windows[i].explanation;
            presets.push_back({.digit = int(i) + 1,
                               .name = named.empty() ? "Window " + std::to_string(i + 1) : named,
                               .window = windows[i]});
        }
    }
    if (volume.valueRange())
        presets.push_back(
            {.digit = kAllValues, .name = "All values", .window = windowOver(*volume.valueRange())});
    return presets;
}

std::optional<WindowPreset> windowPreset(const Volume& volume, int digit) {
    for (WindowPreset& preset : windowPresets(volume))
        if (preset.digit == digit) return std::move(preset);
    return std::nullopt;
}

}  // namespace macula::app
