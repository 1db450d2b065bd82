#include "pipeline/volume/colour_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/srgb.h"

namespace macula {

namespace {

constexpr std::array<std::pair<ColourSpace, std::string_view>, 6> kNames{
    {{ColourSpace::rgb, "rgb"},
     {ColourSpace::hsv, "hsv"},
     {ColourSpace::hsvWrap, "hsvWrap"},
     {ColourSpace::lab, "lab"},
     {ColourSpace::diverging, "diverging"},
     {ColourSpace::step, "step"}}};

const glm::dvec3 kWhite(0.9505, 1.0, 1.089);  // D65

// Hue, saturation and value, each 0 to 1; the hue of a grey is 0.
glm::dvec3 hsvFromRgb(const glm::dvec3& rgb) {
    const double high = std::max({rgb.r, rgb.g, rgb.b});
    const double chroma = high - std::min({rgb.r, rgb.g, rgb.b});
    if (chroma <= 0.0) return {0.0, 0.0, high};
    double hue = 0.0;
    if (high == rgb.r) {
        hue = (rgb.g - rgb.b) / chroma;
    } else if (high == rgb.g) {
        hue = 2.0 + (rgb.b - rgb.r) / chroma;
    } else {
        hue = 4.0 + (rgb.r - rgb.g) / chroma;
    }
    hue /= 6.0;
    return {hue < 0.0 ? hue + 1.0 : hue, chroma / high, high};
}

glm::dvec3 rgbFromHsv(const glm::dvec3& hsv) {
    const auto channel = [&](double offset) {
        const double k = std::fmod(offset + hsv.x * 6.0, 6.0);
        return hsv.z * (1.0 - hsv.y * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
    };
    return {channel(5.0), channel(3.0), channel(1.0)};
}

glm::dvec3 mixHsv(const glm::dvec3& from, const glm::dvec3& to, double fraction, bool wrap) {
    glm::dvec3 a = hsvFromRgb(from);
    glm::dvec3 b = hsvFromRgb(to);
    if (wrap && std::abs(a.x - b.x) > 0.5) (a.x > b.x ? a.x : b.x) -= 1.0;
    glm::dvec3 hsv = glm::mix(a, b, fraction);
    if (hsv.x < 0.0) hsv.x += 1.0;
    return rgbFromHsv(hsv);
}

// Moreland, "Diverging Color Maps for Scientific Visualization" (2009): L*a*b* in polar form, with magnitude,
// saturation angle and hue angle.
struct Msh {
    double magnitude = 0.0;
    double saturation = 0.0;
    double hue = 0.0;
};

constexpr double kPi = std::numbers::pi;
constexpr double kSaturated = 0.05;
constexpr double kDistinctHues = kPi / 3.0;
constexpr double kWhiteMagnitude = 88.0;

Msh mshFromRgb(const glm::dvec3& rgb) {
    const glm::dvec3 lab = labFromSrgb(rgb);
    Msh msh;
    msh.magnitude = glm::length(lab);
    msh.saturation = msh.magnitude > 0.001 ? std::acos(std::clamp(lab.x / msh.magnitude, -1.0, 1.0)) : 0.0;
    msh.hue = msh.saturation > 0.001 ? std::atan2(lab.z, lab.y) : 0.0;
    return msh;
}

glm::dvec3 rgbFromMsh(const Msh& msh) {
    return srgbFromLab(msh.magnitude * glm::dvec3(std::cos(msh.saturation),
                                                  std::sin(msh.saturation) * std::cos(msh.hue),
                                                  std::sin(msh.saturation) * std::sin(msh.hue)));
}

double angleBetween(double a, double b) {
    const double difference = std::fmod(std::abs(a - b), 2.0 * kPi);
    return difference > kPi ? 2.0 * kPi - difference : difference;
}

// The hue for an unsaturated end of another magnitude, so that the path to it looks straight (AdjustHue).
double spunHue(const Msh& saturated, double magnitude) {
    if (saturated.magnitude >= magnitude - 0.1) return saturated.hue;
    const double spin = saturated.saturation *
                        std::sqrt(magnitude * magnitude - saturated.magnitude * saturated.magnitude) /
                        (saturated.magnitude * std::sin(saturated.saturation));
    return saturated.hue > -0.3 * kPi ? saturated.hue + spin : saturated.hue - spin;
}

glm::dvec3 mixDiverging(const glm::dvec3& from, const glm::dvec3& to, double fraction) {
    Msh a = mshFromRgb(from);
    Msh b = mshFromRgb(to);
    if (a.saturation > kSaturated && b.saturation > kSaturated &&
        angleBetween(a.hue, b.hue) > kDistinctHues) {
        const Msh white{std::max({a.magnitude, b.magnitude, kWhiteMagnitude}), 0.0, 0.0};
        (fraction < 0.5 ? b : a) = white;
        fraction = fraction < 0.5 ? 2.0 * fraction : 2.0 * fraction - 1.0;
    }
    if (a.saturation < kSaturated && b.saturation > kSaturated) {
        a.hue = spunHue(b, a.magnitude);
    } else if (b.saturation < kSaturated && a.saturation > kSaturated) {
        b.hue = spunHue(a, b.magnitude);
    }
    return rgbFromMsh({std::lerp(a.magnitude, b.magnitude, fraction),
                       std::lerp(a.saturation, b.saturation, fraction), std::lerp(a.hue, b.hue, fraction)});
}

}  // namespace

glm::dvec3 labFromSrgb(const glm::dvec3& rgb) {
    const glm::dvec3 light(decodedSrgb(rgb.r), decodedSrgb(rgb.g), decodedSrgb(rgb.b));
    const glm::dvec3 xyz = glm::dvec3(0.4124 * light.r + 0.3576 * light.g + 0.1805 * light.b,
                                      0.2126 * light.r + 0.7152 * light.g + 0.0722 * light.b,
                                      0.0193 * light.r + 0.1192 * light.g + 0.9505 * light.b) /
                           kWhite;
    const auto root = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    const glm::dvec3 f(root(xyz.x), root(xyz.y), root(xyz.z));
    return {116.0 * f.y - 16.0, 500.0 * (f.x - f.y), 200.0 * (f.y - f.z)};
}

glm::dvec3 srgbFromLab(const glm::dvec3& lab) {
    const double y = (lab.x + 16.0) / 116.0;
    const auto cube = [](double t) { return t * t * t > 0.008856 ? t * t * t : (t - 16.0 / 116.0) / 7.787; };
    const glm::dvec3 xyz = kWhite * glm::dvec3(cube(y + lab.y / 500.0), cube(y), cube(y - lab.z / 200.0));
    glm::dvec3 rgb(encodedSrgb(3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z),
                   encodedSrgb(-0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z),
                   encodedSrgb(0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z));
    rgb /= std::max({1.0, rgb.r, rgb.g, rgb.b});
    return glm::max(rgb, glm::dvec3(0.0));
}

glm::dvec3 mixColours(ColourSpace space, const glm::dvec3& from, const glm::dvec3& to, double fraction) {
    glm::dvec3 mixed = glm::mix(from, to, fraction);
    if (space == ColourSpace::hsv || space == ColourSpace::hsvWrap) {
        mixed = mixHsv(from, to, fraction, space == ColourSpace::hsvWrap);
    } else if (space == ColourSpace::lab) {
        mixed = srgbFromLab(glm::mix(labFromSrgb(from), labFromSrgb(to), fraction));
    } else if (space == ColourSpace::diverging) {
        mixed = mixDiverging(from, to, fraction);
    }
    return glm::clamp(mixed, 0.0, 1.0);
}

std::string_view colourSpaceName(ColourSpace space) {
    return std::find_if(kNames.begin(), kNames.end(), [&](const auto& entry) { return entry.first == space; })
        ->second;
}

std::optional<ColourSpace> colourSpaceNamed(std::string_view name) {
    const auto found =
        std::find_if(kNames.begin(), kNames.end(), [&](const auto& entry) { return entry.second == name; });
    if (found == kNames.end()) return std::nullopt;
    return found->first;
}

}  // namespace macula
