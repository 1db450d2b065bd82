// The quantities of a pixel that the loss of a splat model compares, and their derivatives with respect to
// the pixel. No branches but on parameters of all pixels: also C++ where float is a vector of several pixels
// (base/vector_in_glsl.h).
//
// Needs tone_neutral.glsl.

// Larger numbers are meaningless, and their fourth powers would overflow.
#define MOST_COMPARED 1e6

// The display transform has slope 0 at black (the toe of the tone map) and almost none above white, where the
// slope falls with the square of the radiance: pixels much too bright would get hardly any gradient. So this
// share of the compared value is ln(1 + radiance), whose slope is positive everywhere. Equal pictures stay
// equal.
#define PLAIN_SHARE 0.05

struct ComparedPixel {
    vec3 over;  // over the background
    vec4 value;
};

vec4 boundedPixel(vec4 value) {
    return clamp(value, vec4(-MOST_COMPARED), vec4(MOST_COMPARED));
}

// The derivative of the largest or smallest channel: channels that tie share it, so that greys stay grey.
vec3 shareOf(vec3 value, float extreme) {
    vec3 share =
        vec3(mix(float(0.0), float(1.0), value.x == extreme), mix(float(0.0), float(1.0), value.y == extreme),
             mix(float(0.0), float(1.0), value.z == extreme));
    return share / (share.x + share.y + share.z);
}

#define TONE_DESATURATION 0.15

// Intermediate results of toneMapNeutral, for its derivatives.
struct TonePath {
    vec3 lowShare;      // derivative of the lowest channel by each channel
    float offsetSlope;  // derivative of the offset by the lowest channel
    vec3 lifted;
    bool isCompressed;  // if false, the rest has no meaning
    float peak;
    vec3 peakShare;
    float slope;  // its square is the derivative of newPeak by peak
    float newPeak;
    float ratio;
    float keep;
};

TonePath tonePathOf(vec3 colour) {
    float startCompression = float(0.8 - 0.04);
    float low = min(colour.x, min(colour.y, colour.z));
    float offset = mix(float(0.04), low - float(6.25) * low * low, low < float(0.08));
    TonePath path;
    path.lowShare = shareOf(colour, low);
    path.offsetSlope = mix(float(0.0), float(1.0) - float(12.5) * low, low < float(0.08));
    path.lifted = colour - vec3(offset);
    path.peak = max(path.lifted.x, max(path.lifted.y, path.lifted.z));
    path.isCompressed = path.peak >= startCompression;
    float d = float(1.0) - startCompression;
    path.peakShare = shareOf(path.lifted, path.peak);
    path.slope = d / (path.peak + d - startCompression);
    path.newPeak = float(1.0) - d * path.slope;
    path.ratio = path.newPeak / path.peak;
    path.keep = float(1.0) / (float(TONE_DESATURATION) * (path.peak - path.newPeak) + float(1.0));
    return path;
}

// Takes a gradient `back` with respect to toneMapNeutral(colour) to the gradient with respect to `colour`,
// step by step through that function.
vec3 toneMapNeutralBack(vec3 colour, vec3 back) {
    TonePath path = tonePathOf(colour);
    vec3 ofScaled = back * path.keep;
    float ofKeep = dot(back, path.lifted * path.ratio - vec3(path.newPeak)) * float(-TONE_DESATURATION) *
                   path.keep * path.keep;  // by peak - newPeak
    float ofRatio = dot(ofScaled, path.lifted) / path.peak;
    float ofNewPeak = (back.x + back.y + back.z) * (float(1.0) - path.keep) + ofRatio - ofKeep;
    float ofPeak = ofKeep - ofRatio * path.ratio + ofNewPeak * path.slope * path.slope;
    vec3 ofLifted = mix(back, ofScaled * path.ratio + path.peakShare * ofPeak, bvec3(path.isCompressed));
    return ofLifted - path.lowShare * ((ofLifted.x + ofLifted.y + ofLifted.z) * path.offsetSlope);
}

float encodeSrgbSlope(float linear) {
    float c = clamp(linear, float(0.0), float(1.0));
    return mix(float(1.055 / 2.4) * pow(c, float(1.0 / 2.4 - 1.0)), float(12.92), c <= float(0.0031308));
}

// A premultiplied pixel as it is compared: exposed, over the (not exposed) background, display-encoded if
// `display` is set; and its coverage. Bounded.
ComparedPixel comparedPixel(vec4 premultiplied, vec3 background, float exposure, bool display) {
    ComparedPixel pixel;
    vec4 bounded = boundedPixel(
        vec4(premultiplied.x * exposure + background.x * (float(1.0) - premultiplied.w),
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
                           rest * encodeSrgb(mapped.z) + float(PLAIN_SHARE) * log(float(1.0) + pixel.over.z),
                           bounded.w);
    }
    return pixel;
}

// The change of toneMapNeutral(colour), to first order, for a change of colour: toneMapNeutralBack is its
// transpose.
vec3 toneMapNeutralChange(vec3 colour, vec3 change) {
    TonePath path = tonePathOf(colour);
    vec3 ofLifted = change - vec3(path.offsetSlope * dot(path.lowShare, change));
    float ofPeak = dot(path.peakShare, ofLifted);
    float ofNewPeak = path.slope * path.slope * ofPeak;
    float ofRatio = (ofNewPeak - path.ratio * ofPeak) / path.peak;
    float ofKeep = float(-TONE_DESATURATION) * path.keep * path.keep * (ofPeak - ofNewPeak);
    vec3 ofScaled = ofLifted * path.ratio + path.lifted * ofRatio;
    vec3 compressed = ofScaled * path.keep + (path.lifted * path.ratio - vec3(path.newPeak)) * ofKeep +
                      vec3(ofNewPeak * (float(1.0) - path.keep));
    return mix(ofLifted, compressed, bvec3(path.isCompressed));
}

// The change of the compared colours, to first order, for a change of the colours over the background.
vec3 comparedChange(vec3 over, vec3 change, bool display) {
    if (!display) return change;
    vec3 mapped = toneMapNeutral(over);
    vec3 slopes = vec3(encodeSrgbSlope(mapped.x), encodeSrgbSlope(mapped.y), encodeSrgbSlope(mapped.z));
    return toneMapNeutralChange(over, change) * slopes * float(1.0 - PLAIN_SHARE) +
           change * float(PLAIN_SHARE) / (over + vec3(float(1.0)));
}

// Takes a gradient `back` with respect to ComparedPixel::value to the gradient with respect to the
// premultiplied pixel. Clamped values keep the slope at the bound, so that they are pulled back into range.
vec4 comparedPixelBack(vec3 over, vec4 back, vec3 background, float exposure, bool display) {
    vec3 ofOver = vec3(back.x, back.y, back.z);
    if (display) {
        vec3 mapped = toneMapNeutral(over);
        float rest = float(1.0 - PLAIN_SHARE);
        vec3 slopes = vec3(encodeSrgbSlope(mapped.x), encodeSrgbSlope(mapped.y), encodeSrgbSlope(mapped.z));
        ofOver = toneMapNeutralBack(over, ofOver * slopes * rest) +
                 ofOver * float(PLAIN_SHARE) / (over + vec3(1.0));
    }
    return vec4(ofOver * exposure, back.w - dot(ofOver, background));
}
