// The matter that a path meets at a vertex. Where the value changes steeply, two kinds of matter meet, and
// scatter like a surface.
//
// Needs, besides gradient.glsl and scattering.glsl: useSurfaces(), a constant.

// The gradient from which a surface gets its normal: that of one of the eight voxels around, drawn with its
// trilinear weight. The difference of two voxels blurs along its axis like a box two voxels wide. With as
// much blur across the axis the normal of an edge keeps its direction; plain central differences are off by
// up to six degrees. So each difference is taken at a voxel jittered across its axis: for trilinear values
// with weights of 1/6, 4/6 and 1/6 (Sobel's operator with the variance of that box), which leaves one degree;
// for a spline's values at random within such a box, so that the mean is the gradient of one blurred volume,
// which leaves a fifth of a degree.
vec3 surfaceGradientByChance(vec3 p, INOUT(Rng) rng) {
    vec3 at = p;
    for (bool moves = useSmooth(); moves; moves = false) at = movedByChance(p, rng);
    ivec3 last = params.volumeSize - ivec3(1);
    vec3 place = clamp(at - vec3(0.5), vec3(0.0), vec3(last)) + random01Coarse3(rng);
    ivec3 voxel = min(ivec3(place), last);
    vec3 chance = random01Coarse3(rng);
    vec3 across = floor(place) + floor(chance - vec3(1.0 / 6.0)) + floor(chance + vec3(1.0 / 6.0));
    if (useSmooth()) across = floor(place + float(2.0) * chance - vec3(1.0));
    ivec3 b = clamp(ivec3(across), ivec3(0), last);
    ivec3 low = max(voxel - ivec3(1), ivec3(0));
    ivec3 high = min(voxel + ivec3(1), last);
    return worldGradient(vec3(fetchStored(ivec3(high.x, b.y, b.z)) - fetchStored(ivec3(low.x, b.y, b.z)),
                              fetchStored(ivec3(b.x, high.y, b.z)) - fetchStored(ivec3(b.x, low.y, b.z)),
                              fetchStored(ivec3(b.x, b.y, high.z)) - fetchStored(ivec3(b.x, b.y, low.z))) *
                         float(0.5));
}

// The volume's matter at a point, for a path that arrives along `direction`; a second volume has no surfaces.
Matter matterAt(vec3 p, vec3 direction, vec3 albedo, float secondShare, INOUT(Rng) rng) {
    Matter m = Matter(albedo, vec3(0.0), float(0.0));
    for (bool asks = useSurfaces(); asks; asks = false) {
        // On average this scatters like the voxels around, each with its trilinear weight.
        vec3 gradient = surfaceGradientByChance(p, rng);
        float steep = dot(gradient, gradient);
        float most = params.surfaceGradient * params.surfaceGradient;
        m.surface = params.surfaceWeight * (float(1.0) - secondShare) * steep / (steep + most);
        if (steep > float(0.0))
            m.normal =
                gradient * ((dot(gradient, direction) > float(0.0) ? float(-1.0) : float(1.0)) / sqrt(steep));
    }
    return m;
}
