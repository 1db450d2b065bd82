// How little of a splat's power (splat_blend.glsl) there is in a rectangle. Also C++ where float is a vector
// of rectangles (base/vector_in_glsl.h), hence no branches.

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
