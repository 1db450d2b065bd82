// How far a traced picture is to be trusted over splats of the same view, where both show something.
//
// Traced light errs by noise, whose mean square V is known. Splats err by what they have not learnt, which is not known;
// but the square D² of the difference of both is, on average, V and the square of that error. Traced light that is weighed
// by 1 - V / D², of means over a window, errs least (Wiener). V and D² are of luminance; D² is of coverage too, whose noise
// is small: the guides know it.
//
// Needs from its host: `trust` (TrustPush); by index of a pixel fetchLight (premultiplied, linear), fetchVariance (of its
// luminance) and fetchSplats (premultiplied, linear, before their gain); by a pixel fetchTerms, of termsInRow. And
// picture.glsl.

// The window is so many pixels to each side.
#define TRUST_RADIUS 3
// Where light is darker than this, its differences count as they do here: in a display's encoding one counts the more the
// darker it is, but for black.
#define TRUST_DARKEST 0.01
// The luminance of what may lie behind a picture that does not cover: 18 % grey.
#define TRUST_BACKDROP 0.18

// Noise and squared difference of a pixel.
vec2 trustTerms(int index) {
    vec4 light = fetchLight(index);
    vec4 splats = fetchSplats(index) * vec4(vec3(trust.splatGain), float(1.0));
    float traced = luminance(vec3(light.x, light.y, light.z));
    float drawn = luminance(vec3(splats.x, splats.y, splats.z));
    float covers = (light.w - splats.w) * float(TRUST_BACKDROP);
    float difference = (traced - drawn) * (traced - drawn) + covers * covers;
    return vec2(fetchVariance(index), difference) / (max(traced, drawn) + float(TRUST_DARKEST));
}

vec2 termsInRow(ivec2 pixel) {
    vec2 sum = vec2(0.0);
    for (int i = -TRUST_RADIUS; i <= TRUST_RADIUS; ++i) {
        int x = clamp(pixel.x + i, 0, trust.size.x - 1);
        sum += x == pixel.x + i ? trustTerms(pixel.y * trust.size.x + x) : vec2(0.0);
    }
    return sum;
}

float trustAt(ivec2 pixel) {
    vec2 sum = vec2(0.0);
    for (int i = -TRUST_RADIUS; i <= TRUST_RADIUS; ++i) {
        int y = clamp(pixel.y + i, 0, trust.size.y - 1);
        sum += y == pixel.y + i ? fetchTerms(ivec2(pixel.x, y)) : vec2(0.0);
    }
    // Nothing is weighed against splats that are not a number.
    if (!(sum.x > float(0.0)) || !(sum.y >= float(0.0))) return float(1.0);
    return clamp(float(1.0) - sum.x / max(sum.y, sum.x), float(0.0), float(1.0));
}
