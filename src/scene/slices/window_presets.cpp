#include "scene/slices/window_presets.h"

#include <cstddef>
#include <utility>

#include "pipeline/volume/window.h"

namespace macula::scene {

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

// A window from 0 to highSuv. The low ones show tumours against the liver (SUV 2 to 3), the high ones against
// organs with strong uptake.
struct SuvPreset {
    int digit;
    const char* name;
    double highSuv;
};
constexpr SuvPreset kSuvPresets[] = {
    {2, "SUV 0 to 5", 5.0}, {3, "SUV 0 to 7", 7.0}, {4, "SUV 0 to 15", 15.0}, {5, "SUV 0 to 20", 20.0}};

void addThoseOfSeries(std::vector<WindowPreset>& presets, const Volume& volume) {
    const std::vector<DisplayWindow>& windows = volume.windows();
    // For activity, preset 1 is not a window of the series; otherwise it is the first of them.
    std::size_t next = isActivity(volume) ? 0 : 1;
    for (int digit = 2; digit < kAllValues && next < windows.size(); ++digit, ++next) {
        const std::string& named = windows[next].explanation;
        presets.push_back({.digit = digit,
                           .name = named.empty() ? "Window " + std::to_string(next + 1) : named,
                           .window = windows[next]});
    }
}

}  // namespace

std::vector<WindowPreset> windowPresets(const Volume& volume) {
    std::vector<WindowPreset> presets{
        {.digit = 1, .name = isActivity(volume) ? "Usual for PET" : "Of the series"}};
    if (volume.unit() == Unit::hounsfield) {
        for (const CtPreset& ct : kCtPresets)
            presets.push_back(
                {.digit = ct.digit,
                 .name = ct.name,
                 .window = DisplayWindow{
                     .center = ct.levelHu, .width = ct.widthHu, .explanation = {}, .function = {}}});
    } else if (volume.unit() == Unit::suvBodyWeight) {
        for (const SuvPreset& suv : kSuvPresets)
            presets.push_back(
                {.digit = suv.digit, .name = suv.name, .window = windowOver({0.0, suv.highSuv})});
    } else {
        addThoseOfSeries(presets, volume);
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

}  // namespace macula::scene
