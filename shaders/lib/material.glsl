// What a path meets at a vertex. Where the value changes steeply, two kinds of matter meet: it scatters like a surface there.
//
// Needs, beside gradient.glsl and scattering.glsl: useSurfaces(), a constant.

// The gradient at one of the eight voxels around, drawn with its trilinear weight, from its neighbours. So on average a place
// is lit as the voxels around it are, each with its share, and takes six voxels, not forty-eight.
vec3 gradientByChance(vec3 p, INOUT(Rng) rng) {
    vec3 at = p;
    for (bool moves = useSmooth(); moves; moves = false) at = movedByChance(p, rng);
    ivec3 last = params.volumeSize - ivec3(1);
    ivec3 voxel = clamp(ivec3(floor(at - vec3(0.5) + random01Coarse3(rng))), ivec3(0), last);
    ivec3 low = max(voxel - ivec3(1), ivec3(0));
    ivec3 high = min(voxel + ivec3(1), last);
    return worldGradient(vec3(fetchStored(ivec3(high.x, voxel.y, voxel.z)) - fetchStored(ivec3(low.x, voxel.y, voxel.z)),
                              fetchStored(ivec3(voxel.x, high.y, voxel.z)) - fetchStored(ivec3(voxel.x, low.y, voxel.z)),
                              fetchStored(ivec3(voxel.x, voxel.y, high.z)) - fetchStored(ivec3(voxel.x, voxel.y, low.z))) *
                         float(0.5));
}

// The matter of the volume at a point, for a path that comes along `direction`; a second volume has no surface.
Matter matterAt(vec3 p, vec3 direction, vec3 albedo, float secondShare, INOUT(Rng) rng) {
    Matter m = Matter(albedo, vec3(0.0), float(0.0));
    for (bool asks = useSurfaces(); asks; asks = false) {
        vec3 gradient = gradientByChance(p, rng);
        float steep = dot(gradient, gradient);
        float most = params.surfaceGradient * params.surfaceGradient;
        m.surface = params.surfaceWeight * (float(1.0) - secondShare) * steep / (steep + most);
        if (steep > float(0.0)) m.normal = gradient * ((dot(gradient, direction) > float(0.0) ? float(-1.0) : float(1.0)) / sqrt(steep));
    }
    return m;
}
