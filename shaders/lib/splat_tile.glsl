// Whether a splat shows anywhere in a rectangle of pixels. Exact except for rounding, which errs towards yes.
//
// One kernel counts a splat's tiles and another lists them, and both must get the same answers: so the
// compiler must not contract or reorder anything here in one of them only.
//
// Needs splat_blend.glsl.

// A lower bound of powerAt in spite of rounding: subtracts the error of u, relative to its terms.
float leastPowerAt(vec3 conic, vec2 offset) {
    PRECISE float sheared = conic.y * offset.y;
    PRECISE float error = float(1e-6) * (abs(offset.x) + abs(sheared));
    PRECISE float u = max(abs(offset.x + sheared) - error, float(0.0));
    PRECISE float power = float(0.5) * (conic.x * u * u + conic.z * offset.y * offset.y) * float(0.99999);
    return power;
}

// The least power over the rectangle low to high, in offsets from the mean. The power is convex and least at
// 0, so over a rectangle that does not hold 0 it is least on a side that faces 0; on a line it is a parabola.
float leastPowerIn(vec3 conic, vec2 low, vec2 high) {
    vec2 nearest = clamp(vec2(float(0.0)), low, high);
    // On the side of constant x.
    PRECISE float y = -conic.x * conic.y * nearest.x / (conic.x * conic.y * conic.y + conic.z);
    float onColumn = leastPowerAt(conic, vec2(nearest.x, clamp(y, low.y, high.y)));
    // On the side of constant y.
    PRECISE float x = -conic.y * nearest.y;
    float onRow = leastPowerAt(conic, vec2(clamp(x, low.x, high.x), nearest.y));
    return min(onColumn, onRow);
}

// The largest power at which a splat, with an opacity above 0, still shows.
float mostPower(ScreenSplat screen, SplatView view) {
    PRECISE float power = log(screen.opacity / view.minAlpha) * float(1.00001) + float(1e-5);
    return power;
}

// For pixels first <= pixel < end, at least one, and a splat with an opacity above 0.
bool showsIn(ScreenSplat screen, ivec2 first, ivec2 end, SplatView view) {
    vec2 low = vec2(first) + vec2(float(0.5)) - screen.mean;
    vec2 high = vec2(end) - vec2(float(0.5)) - screen.mean;
    return leastPowerIn(screen.conic, low, high) <= mostPower(screen, view);
}
