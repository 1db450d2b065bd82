#include "presets/slicer_vp.h"

#include <array>

#include "base/parsing.h"
#include "presets/preset_name.h"
#include "presets/slicer_light.h"
#include "presets/vtk_curve.h"

namespace macula::presets {

namespace {

constexpr std::size_t kLines = 9;

// The non-blank lines. Fails unless there are nine.
Result<std::array<std::string_view, kLines>> linesOf(const PresetText& file) {
    std::array<std::string_view, kLines> lines;
    std::size_t count = 0;
    std::string_view rest = file.text;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = rest.substr(0, end);
        if (line.find_first_not_of(" \t\r") != std::string_view::npos) {
            if (count < kLines) lines.at(count) = line;
            ++count;
        }
        rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
    }
    if (count == kLines) return lines;
    return Error{ErrorCode::inputNotUsable,
                 Text("A .vp file of 3D Slicer has {} lines; this has {}.", kLines, count), file.where,
                 Text("Check that it is complete.")};
}

}  // namespace

Result<ImportedPresets> presetsFromSlicerVp(const PresetText& file) {
    MACULA_TRY(const auto lines, linesOf(file));
    const auto fail = [&](std::size_t line, Text expected) {
        return Error{ErrorCode::inputNotUsable, Text("Line {} is not as expected.", line + 1), file.where,
                     Text("Expected {}.", std::move(expected))};
    };
    ImportedPreset preset;
    TransferFunction& function = preset.function;
    if (!nameAfter(function, file.fallbackName)) preset.notes.push_back(assumedHounsfield());
    function.source = "3D Slicer";

    const std::optional<Interpolation> interpolation = interpolationFrom(lines[0]);
    if (!interpolation) return fail(0, Text("the interpolation, 0 for nearest or 1 for linear"));
    function.interpolation = *interpolation;
    const std::optional<double> shade = finiteNumber(lines[1]);
    if (!shade || (*shade != 0.0 && *shade != 1.0)) return fail(1, Text("whether it is shaded, 0 or 1"));
    Lighting& light = function.lighting;
    light.shade = *shade == 1.0;
    if (!readLight(lines[2], 1e3, light.diffuse)) return fail(2, Text("the diffuse coefficient, 0 or above"));
    if (!readLight(lines[3], 1e3, light.ambient)) return fail(3, Text("the ambient coefficient, 0 or above"));
    if (!readLight(lines[4], 1e3, light.specular))
        return fail(4, Text("the specular coefficient, 0 or above"));
    if (!readLight(lines[5], 1e6, light.specularPower))
        return fail(5, Text("the specular power, 0 or above"));

    bool clamped = false;
    MACULA_TRY(function.opacity,
               opacityFromText(lines[6], Text("scalar opacity (line 7)"), file.where, clamped));
    MACULA_TRY(function.gradientOpacity,
               opacityFromText(lines[7], Text("gradient opacity (line 8)"), file.where, clamped));
    MACULA_TRY(function.colour, colourFromText(lines[8], Text("colour (line 9)"), file.where, clamped));
    if (clamped) preset.notes.emplace_back(Text("Opacities or colours outside 0 to 1 were clamped."));
    return ImportedPresets{std::move(preset)};
}

}  // namespace macula::presets
