// All matter at a point: the volume, coloured segments, and a second volume. Where two media fill the same
// space, their extinctions add, and their albedos mix in proportion to their extinctions. They share the
// volume's phase function.
//
// A segment colours the volume's matter and scales its extinction, never upwards: majorants still hold.
// Between voxels its share is interpolated, not taken from the nearest one, so that faces of segments are as
// smooth as those of masks and of values; colours and factors are interpolated, never the segments' numbers.
//
// Needs, besides gradient.glsl: useTints() and useSecond(), constants; fetchTint(voxel), 0 where there is
// none, and fetchTintColour(tint): albedo, and the factor of the extinction; fetchSecond(voxel) in entries of
// the second volume's own table, fetchSecondMatter(entry): albedo, and extinction per mm; params.second*.

struct Tint {
    vec3 colour;     // albedo, times strength
    float strength;  // 0: the volume's colour; 1: the segments' colour alone
    float opacity;   // multiplies the extinction
};

Tint tintAt(vec3 p) {
    vec3 q = clamp(p - vec3(0.5), vec3(0.0), vec3(params.volumeSize - ivec3(1)));
    ivec3 low = ivec3(q);
    vec3 f = q - vec3(low);
    Tint tint = Tint(vec3(0.0), float(0.0), float(0.0));
    for (int i = 0; i < 8; ++i) {
        ivec3 step = ivec3(i & 1, (i >> 1) & 1, i >> 2);
        float weight = (step.x == 1 ? f.x : float(1.0) - f.x) * (step.y == 1 ? f.y : float(1.0) - f.y) *
                       (step.z == 1 ? f.z : float(1.0) - f.z);
        int there = fetchTint(min(low + step, params.volumeSize - ivec3(1)));
        vec4 colour = there > 0 ? fetchTintColour(there) : vec4(vec3(0.0), float(1.0));
        tint.colour += vec3(colour) * weight;
        tint.strength += there > 0 ? weight : float(0.0);
        tint.opacity += colour.w * weight;
    }
    tint.opacity = min(tint.opacity, float(1.0));  // rounded weights may sum to a little more
    return tint;
}

vec3 tinted(vec3 albedo, Tint tint) {
    return albedo * max(float(1.0) - tint.strength, float(0.0)) + tint.colour;
}

// From voxel coordinates of the volume to those of the second one, both with integers at faces.
vec3 inSecond(vec3 p) {
    return params.secondOrigin + params.secondFromVoxelX * p.x + params.secondFromVoxelY * p.y +
           params.secondFromVoxelZ * p.z;
}

bool isOutsideOfSecond(vec3 q) {
    vec3 room = min(q, vec3(params.secondSize) - q);
    return !(min(room.x, min(room.y, room.z)) >= float(0.0));
}

// The value at a point of the second volume, in its own voxel coordinates, as a continuous position in its
// table; always trilinear.
float secondEntry(vec3 p) {
    vec3 q = clamp(p - vec3(0.5), vec3(0.0), vec3(params.secondSize - ivec3(1)));
    ivec3 low = ivec3(q);
    ivec3 high = min(low + ivec3(1), params.secondSize - ivec3(1));
    Corners c;
    c.fraction = q - vec3(low);
    c.near = vec4(fetchSecond(low), fetchSecond(ivec3(high.x, low.y, low.z)),
                  fetchSecond(ivec3(low.x, high.y, low.z)), fetchSecond(ivec3(high.x, high.y, low.z)));
    c.far = vec4(fetchSecond(ivec3(low.x, low.y, high.z)), fetchSecond(ivec3(high.x, low.y, high.z)),
                 fetchSecond(ivec3(low.x, high.y, high.z)), fetchSecond(high));
    return interpolated(c);
}

// Albedo of the second volume at a point, and its extinction per mm. Both are linear between entries; 0
// outside the second volume.
vec4 secondMatter(vec3 p) {
    vec3 q = inSecond(p);
    if (isOutsideOfSecond(q)) return vec4(0.0);
    float entry = secondEntry(q);
    int low = int(entry);
    vec4 matter = fetchSecondMatter(low);
    return matter + (fetchSecondMatter(low + 1) - matter) * (entry - float(low));
}

// The second volume's gradient: central differences with one of its voxels to either side, in entries per mm
// along the world's axes; 0 where all values around are equal.
vec3 secondGradient(vec3 p) {
    vec3 q = inSecond(p);
    if (isOutsideOfSecond(q)) return vec3(0.0);
    vec3 x = vec3(float(1.0), float(0.0), float(0.0));
    vec3 y = vec3(float(0.0), float(1.0), float(0.0));
    vec3 z = vec3(float(0.0), float(0.0), float(1.0));
    vec3 perSecond = vec3(secondEntry(q + x) - secondEntry(q - x), secondEntry(q + y) - secondEntry(q - y),
                          secondEntry(q + z) - secondEntry(q - z)) *
                     float(0.5);
    // Transforms by the transposes of both maps: from its voxels to those of the volume, and from these to
    // mm.
    return worldGradient(vec3(dot(params.secondFromVoxelX, perSecond),
                              dot(params.secondFromVoxelY, perSecond),
                              dot(params.secondFromVoxelZ, perSecond)));
}

struct Mixture {
    float first;   // extinction per mm of the volume
    float second;  // of the second volume
};

// The mixture at a point where the volume's value is `entry`, and the part `steep` of its matter is steep.
Mixture mixtureAt(vec3 p, float entry, float steep) {
    Mixture m = Mixture(extinctionAt(p, entry, steep), float(0.0));
    if (useTints() && m.first > float(0.0)) m.first *= tintAt(p).opacity;
    if (useSecond()) m.second = secondMatter(p).w;
    return m;
}

// The extinction per mm of both volumes.
float totalOf(Mixture m) {
    return useSecond() ? m.first + m.second : m.first;
}

// The second volume's share of the extinction, 0 to 1.
float secondShareOf(Mixture m) {
    return useSecond() ? m.second / max(m.first + m.second, float(1e-20)) : float(0.0);
}

vec3 albedoAt(vec3 p, float entry, float steep, float secondShare) {
    int nearest = int(entry + float(0.5));
    vec3 albedo = fetchAlbedo(nearest);
    if (useSteep()) albedo = mix(albedo, vec3(fetchSteepMatter(nearest)), steepShare(p, entry, steep));
    if (useTints()) albedo = tinted(albedo, tintAt(p));
    if (useSecond()) albedo = mix(albedo, vec3(secondMatter(p)), secondShare);
    return albedo;
}
