#include "scene/lights/edited_rig.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/trace/light_rig_json.h"
#include "scene/lights/light_meter.h"

namespace macula::scene {

namespace {

using trace::LightRig;
using trace::SoftLight;

// Returns `low` for NaN.
double within(double value, double low, double high) {
    return value >= low ? std::min(value, high) : low;
}

glm::dvec3 radianceWithin(const glm::dvec3& radiance) {
    return {within(radiance.x, 0.0, trace::kMostRadiance), within(radiance.y, 0.0, trace::kMostRadiance),
            within(radiance.z, 0.0, trace::kMostRadiance)};
}

SoftLight asInFile(SoftLight light) {
    light.azimuthDeg = within(std::remainder(light.azimuthDeg, 360.0), -180.0, 180.0);
    light.elevationDeg = within(light.elevationDeg, -90.0, 90.0);
    light.angularRadiusDeg =
        within(light.angularRadiusDeg, trace::kLeastLightRadiusDeg, trace::kMostLightRadiusDeg);
    light.colour = radianceWithin(light.colour);
    light.radiance = within(light.radiance, 0.0, trace::kMostRadiance);
    return light;
}

Error noSuchLight() {
    return {ErrorCode::usage, Text("There is no such light."), {}, Text("Choose another one of the rig.")};
}

Result<LightRig> own(LightRig rig) {
    const bool shines = std::ranges::any_of(
        rig.lights, [](const SoftLight& light) { return light.colour * light.radiance != glm::dvec3(0.0); });
    if (!shines && rig.ambientZenith + rig.ambientHorizon + rig.ambientNadir == glm::dvec3(0.0))
        return Error{ErrorCode::usage,
                     Text("Without any light the picture would be black."),
                     {},
                     Text("Leave a light, or a sky that is not black.")};
    rig.name = kOwnLightsName;
    rig.title = kOwnLightsTitle;
    return rig;
}

}  // namespace

Result<LightRig> withLight(LightRig rig, std::size_t index, const SoftLight& light) {
    if (index >= rig.lights.size()) return noSuchLight();
    rig.lights[index] = asInFile(light);
    return own(std::move(rig));
}

Result<LightRig> withLightAdded(LightRig rig, const SoftLight& light) {
    if (rig.lights.size() >= trace::kMostLights)
        return Error{
            ErrorCode::usage, Text("The rig has no room for one more light."), {}, Text("Remove one first.")};
    rig.lights.push_back(asInFile(light));
    return own(std::move(rig));
}

Result<LightRig> withoutLight(LightRig rig, std::size_t index) {
    if (index >= rig.lights.size()) return noSuchLight();
    rig.lights.erase(rig.lights.begin() + std::ptrdiff_t(index));
    return own(std::move(rig));
}

double skyOf(const LightRig& rig) {
    return brightnessOf(rig.ambientZenith + 2.0 * rig.ambientHorizon + rig.ambientNadir) / 4.0;
}

Result<LightRig> withSky(LightRig rig, double radiance) {
    const double wanted = within(radiance, 0.0, trace::kMostRadiance);
    const double now = skyOf(rig);
    for (glm::dvec3* part : {&rig.ambientZenith, &rig.ambientHorizon, &rig.ambientNadir})
        *part = now > 0.0 ? radianceWithin(*part * (wanted / now)) : glm::dvec3(wanted);
    return own(std::move(rig));
}

Result<LightRig> keptTo(LightRig rig, trace::LightFrame frame, const LightStand& stand) {
    LightStand next = stand;
    next.frame = frame;
    for (SoftLight& light : rig.lights) light = asInFile(shiningFrom(light, directionTo(light, stand), next));
    rig.frame = frame;
    return own(std::move(rig));
}

}  // namespace macula::scene
