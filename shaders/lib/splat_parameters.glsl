// A splat from its parameters, whose order is that of shared/splat_layout.h.
//
// Needs splat_types.glsl, splat_colour.glsl, int kDegree, and float fetchParameter(int component, int splat).

vec3 fetchParameters3(int component, int splat) {
    return vec3(fetchParameter(component, splat), fetchParameter(component + 1, splat),
                fetchParameter(component + 2, splat));
}
vec3 fetchSh(int coefficient, int splat) {
    return fetchParameters3(kSplatSh + 3 * coefficient, splat);
}

Splat fetchSplat(int splat) {
    Splat s;
    s.position = fetchParameters3(kSplatPosition, splat);
    s.logScale = fetchParameters3(kSplatLogScale, splat);
    s.rotation = vec4(fetchParameter(kSplatRotation, splat), fetchParameters3(kSplatRotation + 1, splat));
    s.opacityLogit = fetchParameter(kSplatOpacity, splat);
    return s;
}

// The sum over bands, before visibleColour (splat_colour.glsl) clamps it at 0.
vec3 colourSumOf(int splat, vec3 direction) {
    vec3 sum = colourOfBand0(fetchParameters3(kSplatDc, splat));
    if (kDegree >= 1)
        sum += colourOfBand1(direction, fetchSh(0, splat), fetchSh(1, splat), fetchSh(2, splat));
    if (kDegree >= 2)
        sum += colourOfBand2(direction, fetchSh(3, splat), fetchSh(4, splat), fetchSh(5, splat),
                             fetchSh(6, splat), fetchSh(7, splat));
    if (kDegree >= 3)
        sum += colourOfBand3(direction, fetchSh(8, splat), fetchSh(9, splat), fetchSh(10, splat),
                             fetchSh(11, splat), fetchSh(12, splat), fetchSh(13, splat), fetchSh(14, splat));
    return sum;
}

// A splat in the picture, and its visible colour.
struct ColouredSplat {
    ScreenSplat screen;
    vec3 colour;
};
ColouredSplat projectColoured(int index, SplatView view) {
    Splat splat = fetchSplat(index);
    vec3 sum = colourSumOf(index, directionTo(splat.position, view));
    ColouredSplat projected;
    projected.screen = projectSplat(splat, view);
    // A splat whose colour is not finite does not show: opacity decides that.
    projected.screen.opacity = mix(float(0.0), projected.screen.opacity, isFinite(vec4(sum, float(0.0))));
    projected.colour = visibleColour(sum);
    return projected;
}

// The derivatives of a loss by the parameters of a splat, for degrees 0 and 1.
struct ParametersGradient {
    SplatGradient shape;
    vec3 dc;
    Band1Gradient sh;  // not set at degree 0
};
// `g` is the derivative by the splat in the picture, `screen`, which shows.
ParametersGradient parametersGradient(int index, SplatView view, ScreenSplat screen, ScreenGradient g) {
    Splat splat = fetchSplat(index);
    vec3 direction = directionTo(splat.position, view);
    vec3 bySum = sumGradient(colourSumOf(index, direction), g.colour);
    ParametersGradient result;
    result.shape = projectionGradient(splat, view, screen, g);
    result.dc = bySum * band0Slope();
    if (kDegree == 1) {
        result.shape.position += colourPositionGradient(splat.position, view, fetchSh(0, index),
                                                        fetchSh(1, index), fetchSh(2, index), bySum);
        result.sh = band1Gradient(direction, bySum);
    }
    return result;
}
