// How much to trust a traced picture over splats of the same view, where both show something.
//
// Traced light has noise, whose mean square V is known. Splats have an unknown error where they have not
// learnt enough; but the squared difference D² of both is, on average, V plus the square of that error. The
// Wiener filter's weight for traced light, 1 - V / D², then has the least error. V and D² are summed over a
// window. Both measure luminance; D² also coverage, which has little noise because it comes from the guides.
//
// Needs picture.glsl.

// The window extends so many pixels to each side.
#define TRUST_RADIUS 3
// Differences count more in darker light, as in a display's encoding, but no more than at this light.
#define TRUST_DARKEST 0.01
// The assumed luminance of the background where coverage is below 1: 18 % grey.
#define TRUST_BACKDROP 0.18

// V and D² of a pixel, from two linear premultiplied colours and the variance of the traced luminance.
vec2 trustTerms(vec4 traced, float variance, vec4 splats) {
    float ofTracer = luminance(vec3(traced.x, traced.y, traced.z));
    float ofSplats = luminance(vec3(splats.x, splats.y, splats.z));
    float covers = (traced.w - splats.w) * float(TRUST_BACKDROP);
    float difference = (ofTracer - ofSplats) * (ofTracer - ofSplats) + covers * covers;
    return vec2(variance, difference) / (max(ofTracer, ofSplats) + float(TRUST_DARKEST));
}

// The trust from sums of trustTerms. If splats are NaN, traced light is fully trusted.
float trustOf(vec2 terms) {
    if (!(terms.x > float(0.0)) || !(terms.y >= float(0.0))) return float(1.0);
    return clamp(float(1.0) - terms.x / max(terms.y, terms.x), float(0.0), float(1.0));
}
