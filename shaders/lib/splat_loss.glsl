// What the loss of a splat model compares of a pixel, and how a change of that comes from the pixel.
//
// Needs picture.glsl.

// Beyond this the numbers say nothing, and squares of squares would overflow.
#define MOST_COMPARED 1e6

// The display transform has slope 0 at black (the toe of the tone map) and next to none above white, where the slope falls
// with the square of the radiance: what is much too bright there would hardly be told so. So this part of what is compared
// is ln(1 + radiance), whose slope is above 0 everywhere. Equal pictures stay equal.
#define PLAIN_SHARE 0.05

struct ComparedPixel {
    vec3 over;  // over the background
    vec4 value;
};

vec4 boundedPixel(vec4 value) {
    return clamp(value, vec4(-MOST_COMPARED), vec4(MOST_COMPARED));
}

// Channels that are the largest (or smallest) share it equally, so that what is grey stays grey.
vec3 shareOf(vec3 value, float extreme) {
    vec3 share = vec3(value.x == extreme ? float(1.0) : float(0.0), value.y == extreme ? float(1.0) : float(0.0),
                      value.z == extreme ? float(1.0) : float(0.0));
    return share / (share.x + share.y + share.z);
}

// The gradient with respect to `colour` of what has the gradient `back` with respect to toneMapNeutral(colour). Step by step
// that function's derivative.
vec3 toneMapNeutralBack(vec3 colour, vec3 back) {
    float startCompression = float(0.8 - 0.04);
    float desaturation = float(0.15);
    float low = min(colour.x, min(colour.y, colour.z));
    float offset = low < float(0.08) ? low - float(6.25) * low * low : float(0.04);
    float offsetSlope = low < float(0.08) ? float(1.0) - float(12.5) * low : float(0.0);
    vec3 lifted = colour - vec3(offset);
    float peak = max(lifted.x, max(lifted.y, lifted.z));
    vec3 ofLifted = back;
    if (peak >= startCompression) {
        float d = float(1.0) - startCompression;
        float slope = d / (peak + d - startCompression);
        float newPeak = float(1.0) - d * slope;
        float ratio = newPeak / peak;
        float keep = float(1.0) / (desaturation * (peak - newPeak) + float(1.0));
        vec3 ofScaled = back * keep;
        float ofKeep = dot(back, lifted * ratio - vec3(newPeak)) * -desaturation * keep * keep;  // by peak - newPeak
        float ofRatio = dot(ofScaled, lifted) / peak;
        float ofNewPeak = (back.x + back.y + back.z) * (float(1.0) - keep) + ofRatio - ofKeep;
        float ofPeak = ofKeep - ofRatio * ratio + ofNewPeak * slope * slope;
        ofLifted = ofScaled * ratio + shareOf(lifted, peak) * ofPeak;
    }
    return ofLifted - shareOf(colour, low) * ((ofLifted.x + ofLifted.y + ofLifted.z) * offsetSlope);
}

float encodeSrgbSlope(float linear) {
    float c = clamp(linear, float(0.0), float(1.0));
    return c <= float(0.0031308) ? float(12.92) : float(1.055 / 2.4) * pow(c, float(1.0 / 2.4 - 1.0));
}

// A premultiplied pixel as it is compared: over the background, where it is to be looked at as the display shows it
// (exposed, as displayColour: the background is not), and its coverage. Bounded.
ComparedPixel comparedPixel(vec4 premultiplied, vec3 background, float exposure, bool display) {
    ComparedPixel pixel;
    vec4 bounded = boundedPixel(vec4(premultiplied.x * exposure + background.x * (float(1.0) - premultiplied.w),
                                     premultiplied.y * exposure + background.y * (float(1.0) - premultiplied.w),
                                     premultiplied.z * exposure + background.z * (float(1.0) - premultiplied.w), premultiplied.w));
    pixel.over = vec3(bounded.x, bounded.y, bounded.z);
    pixel.value = bounded;
    if (display) {
        pixel.over = max(pixel.over, vec3(0.0));
        vec3 mapped = toneMapNeutral(pixel.over);
        float rest = float(1.0 - PLAIN_SHARE);
        pixel.value = vec4(rest * encodeSrgb(mapped.x) + float(PLAIN_SHARE) * log(float(1.0) + pixel.over.x),
                           rest * encodeSrgb(mapped.y) + float(PLAIN_SHARE) * log(float(1.0) + pixel.over.y),
                           rest * encodeSrgb(mapped.z) + float(PLAIN_SHARE) * log(float(1.0) + pixel.over.z), bounded.w);
    }
    return pixel;
}

// How toneMapNeutral(colour) changes with a small change of colour: the derivative of which toneMapNeutralBack is the transpose.
vec3 toneMapNeutralChange(vec3 colour, vec3 change) {
    float startCompression = float(0.8 - 0.04);
    float desaturation = float(0.15);
    float low = min(colour.x, min(colour.y, colour.z));
    float offset = low < float(0.08) ? low - float(6.25) * low * low : float(0.04);
    float offsetSlope = low < float(0.08) ? float(1.0) - float(12.5) * low : float(0.0);
    vec3 lifted = colour - vec3(offset);
    vec3 ofLifted = change - vec3(offsetSlope * dot(shareOf(colour, low), change));
    float peak = max(lifted.x, max(lifted.y, lifted.z));
    if (peak < startCompression) return ofLifted;
    float d = float(1.0) - startCompression;
    float slope = d / (peak + d - startCompression);
    float newPeak = float(1.0) - d * slope;
    float ratio = newPeak / peak;
    float keep = float(1.0) / (desaturation * (peak - newPeak) + float(1.0));
    float ofPeak = dot(shareOf(lifted, peak), ofLifted);
    float ofNewPeak = slope * slope * ofPeak;
    float ofRatio = (ofNewPeak - ratio * ofPeak) / peak;
    float ofKeep = -desaturation * keep * keep * (ofPeak - ofNewPeak);
    vec3 ofScaled = ofLifted * ratio + lifted * ofRatio;
    return ofScaled * keep + (lifted * ratio - vec3(newPeak)) * ofKeep + vec3(ofNewPeak * (float(1.0) - keep));
}

// How the colours that are compared change, to first order, when those over the background do by `change`.
vec3 comparedChange(vec3 over, vec3 change, bool display) {
    if (!display) return change;
    vec3 mapped = toneMapNeutral(over);
    vec3 slopes = vec3(encodeSrgbSlope(mapped.x), encodeSrgbSlope(mapped.y), encodeSrgbSlope(mapped.z));
    return toneMapNeutralChange(over, change) * slopes * float(1.0 - PLAIN_SHARE) + change * float(PLAIN_SHARE) / (over + vec3(float(1.0)));
}

// The gradient with respect to the premultiplied pixel of what has the gradient `back` with respect to value. Where a bound
// was met it is that of the unbounded value next to it: what is below black or beyond all bounds is drawn back.
vec4 comparedPixelBack(vec3 over, vec4 back, vec3 background, float exposure, bool display) {
    vec3 ofOver = vec3(back.x, back.y, back.z);
    if (display) {
        vec3 mapped = toneMapNeutral(over);
        float rest = float(1.0 - PLAIN_SHARE);
        vec3 slopes = vec3(encodeSrgbSlope(mapped.x), encodeSrgbSlope(mapped.y), encodeSrgbSlope(mapped.z));
        ofOver = toneMapNeutralBack(over, ofOver * slopes * rest) + ofOver * float(PLAIN_SHARE) / (over + vec3(1.0));
    }
    return vec4(ofOver * exposure, back.w - dot(ofOver, background));
}
