// What a path meets at a vertex. Where the value changes steeply, two kinds of matter meet: it scatters like
// a surface there.
//
// Needs, beside gradient.glsl and scattering.glsl: useSurfaces(), a constant.

// The gradient that a surface has its normal from: of one of the eight voxels around, drawn with its
// trilinear weight. The difference of two voxels blurs along its axis like a box two voxels wide. With as
// much blur across, the normal of an edge stays where it is; of central differences alone it is off by up to
// six degrees. So each difference is taken beside its voxel, by chance: where values are trilinear with
// weights of 1/6, 4/6 and 1/6 (Sobel's operator with the variance of that box), which leaves a degree; where
// they are those of the spline somewhere in such a box, so that on average it is the gradient of one blurred
// volume, and leaves a fifth of a degree.
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

// The matter of the volume at a point, for a path that comes along `direction`; a second volume has no
// surface.
Matter matterAt(vec3 p, vec3 direction, vec3 albedo, float secondShare, INOUT(Rng) rng) {
    Matter m = Matter(albedo, vec3(0.0), float(0.0));
    for (bool asks = useSurfaces(); asks; asks = false) {
        // On average a place is lit as the voxels around it are, each with its share.
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
