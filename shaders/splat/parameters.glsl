// The parameters of splats, see shared/splat_layout.h. Needs: layout(constant_id = 0) const int kDegree.
layout(binding = 2) uniform samplerBuffer parameterTexels;

float fetchParameter(int component, int splat) {
    return texelFetch(parameterTexels, component * int(frame.capacity) + splat).x;
}
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

// The sum over bands, before visibleColour (lib/splat_colour.glsl) clamps it at 0.
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
