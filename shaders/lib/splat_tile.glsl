// Whether a splat shows anywhere in a rectangle of pixels. Exact except for rounding, which errs towards yes.
//
// One kernel counts a splat's tiles and another lists them, and both must get the same answers: so the
// compiler must not contract or reorder anything here, or in splat_least_power.glsl, in one of them only.
//
// Needs splat_least_power.glsl, splat_types.glsl.

// The columns and rows that a visible splat may touch: first <= pixel < end.
void pixelsOf(ScreenSplat screen, ivec2 sizePx, OUT(ivec2) first, OUT(ivec2) end) {
    vec2 size = vec2(sizePx);
    vec2 low = clamp(screen.mean - screen.extent - vec2(float(0.5)), vec2(float(0.0)), size);
    vec2 high = clamp(screen.mean + screen.extent + vec2(float(0.5)), vec2(float(0.0)), size);
    first = ivec2(int(ceil(low.x)), int(ceil(low.y)));
    end = ivec2(int(floor(high.x)), int(floor(high.y)));
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
