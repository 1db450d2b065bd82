#include "scene/state/parameters.h"

#include <algorithm>

#include "base/check.h"
#include "scene/transfer/edited_transfer.h"

namespace macula::scene {

namespace {

using trace::Settings;

constexpr std::array<Parameter, 4> kParameters{
    {{.id = "bounces",
      .option = "--bounces",
      .label = "bounces",
      .unit = "",
      .low = 1,
      .high = trace::kMaxBounces,
      .isWhole = true,
      .stale = Stale::light,
      .does = "Scattering events per path of cinematic",
      .get = [](const Settings& s) { return double(s.bounces); },
      .set = [](Settings& s, double value) { s.bounces = int(value); }},
     {.id = "exposure",
      .option = "--exposure",
      .label = "exposure",
      .unit = "",
      .low = 1e-6,
      .high = trace::kMaxGain,
      .stale = Stale::display,
      .does = "Multiplies the picture before the tone map",
      .get = [](const Settings& s) { return s.exposure; },
      .set = [](Settings& s, double value) { s.exposure = value; }},
     {.id = "lightRotationDeg",
      .option = "--light-rotation",
      .label = "light rotation",
      .unit = "degrees",
      .low = -360.0,
      .high = 360.0,
      .stale = Stale::light,
      .does = "Degrees to turn the lights about the vertical, towards the patient's left",
      .get = [](const Settings& s) { return s.lightRotationDeg; },
      .set = [](Settings& s, double value) { s.lightRotationDeg = value; }},
     {.id = "lightStrength",
      .option = "--light-strength",
      .label = "light strength",
      .unit = "",
      .low = 0.0,
      .high = trace::kMaxGain,
      .stale = Stale::light,
      .does = "Multiplies the lights",
      .get = [](const Settings& s) { return s.lightStrength; },
      .set = [](Settings& s, double value) { s.lightStrength = value; }}}};

// Their ranges are those of validate and of preset files.
constexpr std::array<MatterParameter, 6> kMatterParameters{
    {{.id = "surfaceWeight",
      .option = "--surface",
      .label = "surface",
      .unit = "",
      .low = 0.0,
      .high = 1.0,
      .stale = Stale::matter,
      .does = "Part of the light that the steepest boundary scatters like a rough, wet surface",
      .get = [](const TransferFunction& f) { return f.surface.weight; },
      .set = [](TransferFunction& f, double value) { f.surface.weight = value; }},
     {.id = "surfaceGradientPerMm",
      .option = "--surface-gradient",
      .label = "surface gradient",
      .unit = "per mm",
      .low = kLeastGradientPerMm,
      .high = kMostGradientPerMm,
      .stale = Stale::matter,
      .does = "Steepness of a boundary that is half a surface, in values per mm",
      .get = [](const TransferFunction& f) { return f.surface.gradientPerMm; },
      .set = [](TransferFunction& f, double value) { f.surface.gradientPerMm = value; }},
     {.id = "roughness",
      .option = "--roughness",
      .label = "roughness",
      .unit = "",
      .low = kLeastRoughness,
      .high = 1.0,
      .stale = Stale::matter,
      .does = "Of surfaces: highlights are smaller and brighter where it is less",
      .get = [](const TransferFunction& f) { return f.surface.roughness; },
      .set = [](TransferFunction& f, double value) { f.surface.roughness = value; }},
     {.id = "reflectance",
      .option = "--reflectance",
      .label = "reflectance",
      .unit = "",
      .low = 0.0,
      .high = 1.0,
      .stale = Stale::matter,
      .does = "Of surfaces: the part that they reflect of light which falls straight",
      .get = [](const TransferFunction& f) { return f.surface.reflectance; },
      .set = [](TransferFunction& f, double value) { f.surface.reflectance = value; }},
     {.id = "anisotropy",
      .option = "--anisotropy",
      .label = "anisotropy",
      .unit = "",
      .low = -kMostScatteringAnisotropy,
      .high = kMostScatteringAnisotropy,
      .stale = Stale::matter,
      .does = "Of what scatters like a cloud: above 0 light goes on forwards, below 0 it comes back",
      .get = [](const TransferFunction& f) { return f.anisotropy; },
      .set = [](TransferFunction& f, double value) { f.anisotropy = value; }},
     {.id = "steepGradientPerMm",
      .option = "--steep-gradient",
      .label = "steep gradient",
      .unit = "per mm",
      .low = kLeastGradientPerMm,
      .high = kMostGradientPerMm,
      .stale = Stale::matter,
      .does = "Of presets with curves for steep matter: where half of the matter is steep, in values per mm",
      .get = [](const TransferFunction& f) { return f.steep.gradientPerMm; },
      .set = [](TransferFunction& f, double value) { f.steep.gradientPerMm = value; }}}};

// The row with that id, which must be in the table.
template <class Table>
const auto& rowOf(const Table& table, std::string_view id) {
    const auto found = std::ranges::find(table, id, &Table::value_type::id);
    MACULA_CHECK(found != table.end());
    return *found;
}

}  // namespace

std::span<const Parameter> parameters() {
    return kParameters;
}

std::span<const MatterParameter> matterParameters() {
    return kMatterParameters;
}

const Parameter& parameter(std::string_view id) {
    return rowOf(kParameters, id);
}

const MatterParameter& matterParameter(std::string_view id) {
    return rowOf(kMatterParameters, id);
}

}  // namespace macula::scene
