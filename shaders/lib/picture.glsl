// From samples to a picture.

// Kahan's compensated sum: a million samples lose no more than one does.
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

// The square of luminance, for the variance of a pixel. What is brighter than any light is cut, so that the
// square is a number.
float squareOfLuminance(vec3 radiance) {
    float l = min(luminance(radiance), float(1e18));
    return l * l;
}

// Tests the exponent bits: a comparison may be folded away by a compiler that takes all numbers to be finite.
bool isFinite(vec4 v) {
    uint special = 0x7f800000u;
    return (floatBitsToUint(v.x) & special) != special && (floatBitsToUint(v.y) & special) != special &&
           (floatBitsToUint(v.z) & special) != special && (floatBitsToUint(v.w) & special) != special;
}

// The Khronos PBR neutral tone map (2024): colours as they are up to 0.8, highlights compressed and slowly desaturated.
vec3 toneMapNeutral(vec3 colour) {
    float startCompression = float(0.8 - 0.04);
    float desaturation = float(0.15);
    float x = min(colour.x, min(colour.y, colour.z));
    float offset = x < float(0.08) ? x - float(6.25) * x * x : float(0.04);
    colour -= vec3(offset);
    float peak = max(colour.x, max(colour.y, colour.z));
    if (peak < startCompression) return colour;
    float d = float(1.0) - startCompression;
    float newPeak = float(1.0) - d * d / (peak + d - startCompression);
    colour *= newPeak / peak;
    float g = float(1.0) - float(1.0) / (desaturation * (peak - newPeak) + float(1.0));
    return mix(colour, vec3(newPeak), g);
}

// Linear 0 to 1 to display-encoded (IEC 61966-2-1).
float encodeSrgb(float linear) {
    float c = clamp(linear, float(0.0), float(1.0));
    return c <= float(0.0031308) ? c * float(12.92) : float(1.055) * pow(c, float(1.0 / 2.4)) - float(0.055);
}

float decodeSrgb(float encoded) {
    return encoded <= float(0.04045) ? encoded / float(12.92) : pow((encoded + float(0.055)) / float(1.055), float(2.4));
}

// The linear grey that toneMapNeutral and encodeSrgb turn into `encoded`, 0 to 1: for what must be shown as it is. White is
// the limit of the tone map; the brightest grey it gives here is 0.998.
float greyBeforeToneMap(float encoded) {
    float mapped = decodeSrgb(encoded);
    float startCompression = float(0.8 - 0.04);
    if (mapped < startCompression) return mapped < float(0.04) ? sqrt(mapped / float(6.25)) : mapped + float(0.04);
    float d = float(1.0) - startCompression;
    return d * d / max(float(1.0) - mapped, float(0.005)) - d + startCompression + float(0.04);
}

// What a pixel shows: linear premultiplied radiance over a linear background, exposed, tone-mapped, encoded.
vec3 displayColour(vec4 premultiplied, vec3 background, float exposure) {
    vec3 over = vec3(premultiplied.x, premultiplied.y, premultiplied.z) * exposure + background * (float(1.0) - clamp(premultiplied.w, float(0.0), float(1.0)));
    vec3 mapped = toneMapNeutral(max(over, vec3(0.0)));
    return vec3(encodeSrgb(mapped.x), encodeSrgb(mapped.y), encodeSrgb(mapped.z));
}
