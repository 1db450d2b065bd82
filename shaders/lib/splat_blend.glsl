// Blends one splat into one pixel, front to back, premultiplied; and its derivative, also front to back. The
// state of a pixel is one or two numbers, so that a thread can hold several pixels in registers. There are no
// branches: a splat outside the pixel, or after the pixel is finished, has alpha 0 and changes nothing. And
// no
// ?:, but mix(a, b, condition), b where it is true: so that this is also C++ where float is a vector of
// several pixels (base/vector_in_glsl.h).
//
// A pixel is finished once its transmittance is below minTransmittance. The splat that finishes it still
// counts in full; 3DGS leaves it out. There the last bit of a float decides whether two splats of alpha 0.99
// stop at T = 0.01; here such a bit never changes more than minTransmittance.
//
// At its border a splat fades out: alpha is limited to fringe (alpha - minAlpha). With fringe 2 this changes
// alphas between minAlpha and twice that, and there is no step. A very large fringe gives the step of 3DGS.
//
// Needs splat_types.glsl.

// From this fringe on the edge is a step, which has no derivative: as in 3DGS, the derivative is that of raw
// alpha.
#define HARD_EDGE 1000.0

// q / 2 at an offset from the mean.
float powerAt(vec3 conic, vec2 offset) {
    float u = offset.x + conic.y * offset.y;
    return float(0.5) * (conic.x * u * u + conic.z * offset.y * offset.y);
}

// Alpha before it is limited and faded (limitedAlpha).
float rawAlphaAt(ScreenSplat screen, vec2 pixel) {
    return screen.opacity * exp(-powerAt(screen.conic, pixel - screen.mean));
}

float limitedAlpha(float raw, SplatView view) {
    return max(min(min(raw, view.maxAlpha), view.fringe * (raw - view.minAlpha)), float(0.0));
}

// The derivative of limitedAlpha with respect to `raw`.
float alphaSlope(float raw, SplatView view) {
    float faded = view.fringe * (raw - view.minAlpha);
    bool isLimited = raw >= view.maxAlpha && faded >= view.maxAlpha;
    bool isFading = faded < raw && view.fringe < float(HARD_EDGE);
    return mix(float(0.0), mix(float(1.0), view.fringe, isFading), faded > float(0.0) && !isLimited);
}

// The weight of a splat with this alpha in the pixel, by which the caller multiplies and adds up colours and
// depths. The sum of weights is the coverage, 1 - transmittance.
float takeWeight(INOUT(float) transmittance, float alpha, SplatView view) {
    float weight = mix(alpha * transmittance, float(0.0), transmittance < view.minTransmittance);
    transmittance -= weight;
    return weight;
}

// The derivative of the loss with respect to a pixel. If the picture is blended over a background b and the
// result has the derivative g, rgba is (g, -dot(b, g)) (and the derivative with respect to b is (1 -
// coverage) g).
struct PixelGradient {
    vec4 rgba;  // a: with respect to coverage
    float depth;
};

// The worth of a splat: the derivative of the loss with respect to its weight in the pixel.
float worthOf(vec3 colour, float depthMm, PixelGradient pixel) {
    return dot(vec4(colour, float(1.0)), pixel.rgba) + depthMm * pixel.depth;
}

// The backward pass of one splat in one pixel. Before the first splat, `transmittance` is 1 and `remaining`
// the worth of the whole pixel: dot(rgba, g.rgba) + (sum of depths) g.depth. After each call `remaining` is
// the worth of the splats behind. Calls must be in the order of the forward pass. Adds to `sum`.
//
// d/d alpha = T worth - remaining / (1 - alpha), where 1 - alpha is not below 1 - maxAlpha.
void addPixelGradient(ScreenSplat screen, vec3 colour, vec2 pixel, PixelGradient g, SplatView view,
                      INOUT(float) transmittance, INOUT(float) remaining, INOUT(ScreenGradient) sum) {
    vec2 offset = pixel - screen.mean;
    float u = offset.x + screen.conic.y * offset.y;
    float power = float(0.5) * (screen.conic.x * u * u + screen.conic.z * offset.y * offset.y);
    float fall = exp(-power);
    float raw = screen.opacity * fall;
    float alpha = mix(limitedAlpha(raw, view), float(0.0), transmittance < view.minTransmittance);
    float worth = worthOf(colour, screen.depthMm, g);
    float weight = alpha * transmittance;
    remaining -= weight * worth;
    float byAlpha = transmittance * worth - remaining / (float(1.0) - alpha);
    float byRaw = mix(float(0.0), byAlpha * alphaSlope(raw, view), alpha > float(0.0));
    transmittance -= weight;

    float byPower = -byRaw * raw;
    vec2 byOffset =
        vec2(screen.conic.x * u, screen.conic.x * u * screen.conic.y + screen.conic.z * offset.y) * byPower;
    sum.mean -= byOffset;
    sum.conic +=
        vec3(float(0.5) * u * u, screen.conic.x * u * offset.y, float(0.5) * offset.y * offset.y) * byPower;
    sum.opacity += byRaw * fall;
    sum.colour += vec3(g.rgba.x, g.rgba.y, g.rgba.z) * weight;
    sum.depthMm += g.depth * weight;
}
