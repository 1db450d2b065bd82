#include "app/state/parameters.h"

#include <algorithm>

#include "base/check.h"

namespace macula::app {

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

}  // namespace

std::span<const Parameter> parameters() {
    return kParameters;
}

const Parameter& parameter(std::string_view id) {
    const auto found = std::ranges::find(kParameters, id, &Parameter::id);
    MACULA_CHECK(found != kParameters.end());
    return *found;
}

}  // namespace macula::app
