// How far a traced picture is to be trusted over splats of the same view, where both show something.
//
// Noise makes traced light wrong, and its mean square V is known. Splats are wrong where they have not learnt
// enough, and nobody knows by how much; but the square D² of the difference of both is, on average, V and the
// square of their error. The Wiener filter's weight for the traced light, 1 - V / D², then errs least. V and
// D² are sums over a window. Both are of luminance, and D² of coverage too, whose noise is small, since the
// guides know it.
//
// Needs picture.glsl.

// The window is so many pixels to each side.
#define TRUST_RADIUS 3
// Differences count the more the darker the light is, as in a display's encoding, but no more than at this
// light.
#define TRUST_DARKEST 0.01
// The luminance of what may lie behind a picture that does not cover: 18 % grey.
#define TRUST_BACKDROP 0.18

// V and D² of a pixel: of two colours that are linear and premultiplied, and the variance of the first one's
// luminance.
vec2 trustTerms(vec4 traced, float variance, vec4 splats) {
    float ofTracer = luminance(vec3(traced.x, traced.y, traced.z));
    float ofSplats = luminance(vec3(splats.x, splats.y, splats.z));
    float covers = (traced.w - splats.w) * float(TRUST_BACKDROP);
    float difference = (ofTracer - ofSplats) * (ofTracer - ofSplats) + covers * covers;
    return vec2(variance, difference) / (max(ofTracer, ofSplats) + float(TRUST_DARKEST));
}

// By the sums of such terms. Traced light is trusted over splats that are not a number.
float trustOf(vec2 terms) {
    if (!(terms.x > float(0.0)) || !(terms.y >= float(0.0))) return float(1.0);
    return clamp(float(1.0) - terms.x / max(terms.y, terms.x), float(0.0), float(1.0));
}
