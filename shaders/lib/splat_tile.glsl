// Whether a splat shows anywhere in a rectangle of pixels. Exact but for rounding, which is on the side of yes.
//
// Needs splat_blend.glsl.

// The least power that rounding can make of an offset: powerAt with its error, relative to the terms of u, taken off.
float leastPowerAt(vec3 conic, vec2 offset) {
    float sheared = conic.y * offset.y;
    float error = float(1e-6) * (abs(offset.x) + abs(sheared));
    float u = max(abs(offset.x + sheared) - error, float(0.0));
    return float(0.5) * (conic.x * u * u + conic.z * offset.y * offset.y) * float(0.99999);
}

// Of the points of the rectangle low to high, offsets from the mean. The power is convex and least at 0, so over a rectangle
// that does not hold 0 it is least on a side that faces 0; on a line it is a parabola.
float leastPowerIn(vec3 conic, vec2 low, vec2 high) {
    vec2 nearest = clamp(vec2(float(0.0)), low, high);
    // On the side of constant x.
    float y = -conic.x * conic.y * nearest.x / (conic.x * conic.y * conic.y + conic.z);
    float onColumn = leastPowerAt(conic, vec2(nearest.x, clamp(y, low.y, high.y)));
    // On the side of constant y.
    float x = -conic.y * nearest.y;
    float onRow = leastPowerAt(conic, vec2(clamp(x, low.x, high.x), nearest.y));
    return min(onColumn, onRow);
}

// Where the power is above this, a splat whose opacity is above 0 shows nothing.
float mostPower(ScreenSplat screen, SplatView view) {
    return log(screen.opacity / view.minAlpha) * float(1.00001) + float(1e-5);
}

// Pixels first <= pixel < end, at least one; of a splat whose opacity is above 0.
bool showsIn(ScreenSplat screen, ivec2 first, ivec2 end, SplatView view) {
    vec2 low = vec2(first) + vec2(float(0.5)) - screen.mean;
    vec2 high = vec2(end) - vec2(float(0.5)) - screen.mean;
    return leastPowerIn(screen.conic, low, high) <= mostPower(screen, view);
}
