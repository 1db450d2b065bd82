// From sums of samples to display colours.

// Kahan's compensated sum: the rounding error does not grow with the number of samples.
void accumulate(INOUT(vec4) sum, INOUT(vec4) lost, vec4 value) {
    PRECISE vec4 y = value - lost;
    PRECISE vec4 t = sum + y;
    PRECISE vec4 rounded = t - sum;
    lost = rounded - y;
    sum = t;
}

void accumulate(INOUT(vec2) sumAndLost, float value) {
    PRECISE float y = value - sumAndLost.y;
    PRECISE float t = sumAndLost.x + y;
    PRECISE float rounded = t - sumAndLost.x;
    sumAndLost = vec2(t, rounded - y);
}

// Luminance by Rec. 709.
float luminance(vec3 colour) {
    return float(0.2126) * colour.x + float(0.7152) * colour.y + float(0.0722) * colour.z;
}

// The square of luminance, for the variance of a pixel. Clamped far above any light, so that the square is
// finite.
float squareOfLuminance(vec3 radiance) {
    float l = min(luminance(radiance), float(1e18));
    return l * l;
}

#include "lib/finite.glsl"
#include "lib/tone_neutral.glsl"

// OKLab (Ottosson 2020, "A perceptual color space for image processing") of linear sRGB: lightness, and two
// coordinates whose angle is the hue. All three scale with the cube root of the light, so that more or less
// light keeps the hue.
vec3 oklabOf(vec3 c) {
    float third = float(1.0 / 3.0);
    float l = pow(dot(vec3(float(0.4122214708), float(0.5363325363), float(0.0514459929)), c), third);
    float m = pow(dot(vec3(float(0.2119034982), float(0.6806995451), float(0.1073969566)), c), third);
    float s = pow(dot(vec3(float(0.0883024619), float(0.2817188376), float(0.6299787005)), c), third);
    return vec3(float(0.2104542553) * l + float(0.7936177850) * m - float(0.0040720468) * s,
                float(1.9779984951) * l - float(2.4285922050) * m + float(0.4505937099) * s,
                float(0.0259040371) * l + float(0.7827717662) * m - float(0.8086757660) * s);
}

vec3 linearOfOklab(vec3 c) {
    float l = c.x + float(0.3963377774) * c.y + float(0.2158037573) * c.z;
    float m = c.x - float(0.1055613458) * c.y - float(0.0638541728) * c.z;
    float s = c.x - float(0.0894841775) * c.y - float(1.2914855480) * c.z;
    vec3 lms = vec3(l * l * l, m * m * m, s * s * s);
    return vec3(dot(vec3(float(4.0767416621), float(-3.3077115913), float(0.2309699292)), lms),
                dot(vec3(float(-1.2684380046), float(2.6097574011), float(-0.3413193965)), lms),
                dot(vec3(float(-0.0041960863), float(-0.7034186147), float(1.7076147010)), lms));
}

// Lightness is unchanged up to SHOULDER, and becomes white at WHITE_AT times that of white, which is eight
// times its light. Both were chosen by measurement (docs/measurements/tone-map.md).
#define SHOULDER 0.7
#define WHITE_AT 2.0

// Between them Reinhard's extended curve (Reinhard et al. 2002, eq. 4), applied to the part above the
// shoulder: slope 1 at the shoulder, value 1 at WHITE_AT.
float shoulderOf(float lightness) {
    float room = float(1.0 - SHOULDER);
    float white = float((WHITE_AT - SHOULDER) / (1.0 - SHOULDER));
    float above = clamp((lightness - float(SHOULDER)) / room, float(0.0), white);
    float shown =
        float(SHOULDER) + room * above * (float(1.0) + above / (white * white)) / (float(1.0) + above);
    return lightness <= float(SHOULDER) ? lightness : shown;
}

// The inverse for a lightness of 0 to 1: the positive root of a quadratic equation, without cancellation.
float beforeShoulder(float shown) {
    float room = float(1.0 - SHOULDER);
    float white = float((WHITE_AT - SHOULDER) / (1.0 - SHOULDER));
    float y = clamp((shown - float(SHOULDER)) / room, float(0.0), float(1.0));
    float rest = float(1.0) - y;
    float above = float(2.0) * y / (rest + sqrt(rest * rest + float(4.0) * y / (white * white)));
    return shown <= float(SHOULDER) ? shown : float(SHOULDER) + room * above;
}

// The tone map that keeps hue and the order of lightness, both of OKLab. The shoulder compresses lightness,
// and chroma in proportion: the same colour with less light. If a channel is still above 1, chroma is reduced
// at the same lightness and hue until the display can show the colour, by bisection to 2^-16.
vec3 toneMapHue(vec3 colour) {
    vec3 c = min(colour, vec3(float(1e6)));  // is white in any hue
    vec3 lab = oklabOf(c);
    float shown = shoulderOf(lab.x);
    float less = shown / max(lab.x, float(1e-20));
    vec3 mapped = lab.x <= float(SHOULDER) ? c : c * (less * less * less);
    float most = max(mapped.x, max(mapped.y, mapped.z));
    float low = float(0.0);
    float high = float(1.0);
    int halvings = most > float(1.0) ? 16 : 0;
    for (int i = 0; i < halvings; ++i) {
        float share = float(0.5) * (low + high);
        vec3 paler = linearOfOklab(vec3(shown, lab.y * less * share, lab.z * less * share));
        bool fits = max(paler.x, max(paler.y, paler.z)) <= float(1.0);
        low = fits ? share : low;
        high = fits ? high : share;
    }
    vec3 pale = linearOfOklab(vec3(shown, lab.y * less * low, lab.z * less * low));
    return most > float(1.0) ? clamp(pale, vec3(0.0), vec3(1.0)) : mapped;
}

// toneMapHue for grey.
float greyOfToneMapHue(float light) {
    float shown = shoulderOf(pow(light, float(1.0 / 3.0)));
    return shown <= float(SHOULDER) ? light : shown * shown * shown;
}

// The tone map of the settings.
vec3 toneMapped(vec3 colour, bool keepsHue) {
    vec3 mapped = toneMapNeutral(colour);
    for (bool keeps = keepsHue; keeps; keeps = false) mapped = toneMapHue(colour);
    return mapped;
}

// The inverse of encodeSrgb.
float decodeSrgb(float encoded) {
    return encoded <= float(0.04045) ? encoded / float(12.92)
                                     : pow((encoded + float(0.055)) / float(1.055), float(2.4));
}

// The linear grey that the tone map and encodeSrgb turn into `encoded`, 0 to 1: for greys that must be
// displayed unchanged. toneMapNeutral only approaches white; here the brightest grey becomes 0.998.
float greyBeforeToneMap(float encoded, bool keepsHue) {
    float mapped = decodeSrgb(encoded);
    if (keepsHue) {
        float lightness = pow(mapped, float(1.0 / 3.0));
        float before = beforeShoulder(lightness);
        return lightness <= float(SHOULDER) ? mapped : before * before * before;
    }
    float startCompression = float(0.8 - 0.04);
    if (mapped < startCompression)
        return mapped < float(0.04) ? sqrt(mapped / float(6.25)) : mapped + float(0.04);
    float d = float(1.0) - startCompression;
    return d * d / max(float(1.0) - mapped, float(0.005)) - d + startCompression + float(0.04);
}

// The display-encoded colour of a pixel: linear premultiplied radiance, exposed and tone-mapped, over a
// background in linear light that is neither.
vec3 displayColour(vec4 premultiplied, vec3 background, float exposure, bool keepsHue) {
    vec3 light = vec3(premultiplied.x, premultiplied.y, premultiplied.z) * exposure;
    vec3 mapped = toneMapped(max(light, vec3(0.0)), keepsHue);
    vec3 over = mapped + background * (float(1.0) - clamp(premultiplied.w, float(0.0), float(1.0)));
    return vec3(encodeSrgb(over.x), encodeSrgb(over.y), encodeSrgb(over.z));
}
