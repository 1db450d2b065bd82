// The optical medium at a point. Positions are in voxel coordinates with integers at voxel faces: the volume fills
// [0, size]; beyond the outermost centres the outer voxel goes on.
//
// Needs from its host: params.volumeSize, fetchStored(voxel) in table entries, fetchCorners(low, high,
// near, far): the same for the eight corners between two voxels that are at most 1 apart, fetchExtinction(entry) per mm, and
// useTrilinear() and useSmooth(), constants.

// The eight voxels around a point, and where between them it lies.
struct Corners {
    vec4 near;      // at the low end of z: (low, low), (high, low), (low, high), (high, high) along x and y
    vec4 far;       // at its high end
    vec3 fraction;  // 0 to 1
};

Corners cornersAround(vec3 p) {
    vec3 q = clamp(p - vec3(0.5), vec3(0.0), vec3(params.volumeSize - ivec3(1)));
    ivec3 low = ivec3(q);
    Corners c;
    c.fraction = q - vec3(low);
    fetchCorners(low, min(low + ivec3(1), params.volumeSize - ivec3(1)), c.near, c.far);
    return c;
}

float interpolated(Corners c, vec3 fraction) {
    return mix(mix(mix(c.near.x, c.near.y, fraction.x), mix(c.near.z, c.near.w, fraction.x), fraction.y),
               mix(mix(c.far.x, c.far.y, fraction.x), mix(c.far.z, c.far.w, fraction.x), fraction.y), fraction.z);
}
float interpolated(Corners c) {
    return interpolated(c, c.fraction);
}

// The value at a point, as a continuous position in the tables.
float trilinearEntry(vec3 p) {
    return interpolated(cornersAround(p));
}

// One of the eight voxels around, drawn with its trilinear weight.
float stochasticEntry(vec3 p, INOUT(Rng) rng) {
    ivec3 voxel = ivec3(floor(p - vec3(0.5) + random01Coarse3(rng)));
    return fetchStored(clamp(voxel, ivec3(0), params.volumeSize - ivec3(1)));
}

// Interpolation at a place that chance moves by up to a voxel along each axis, by the sum of two even numbers: on average values
// are weighted by a cubic B-spline (a hat over a hat), which has no kinks at the planes of voxels. What is averaged is optics,
// not values, but within the width of one voxel: one fetch, as for interpolation (stochastic texture filtering, Pharr et al. 2024).
vec3 movedByChance(vec3 p, INOUT(Rng) rng) {
    vec3 first = random01Coarse3(rng);
    return p + first + random01Coarse3(rng) - vec3(1.0);
}

float entryAt(vec3 p, INOUT(Rng) rng) {
    vec3 at = p;
    // lavapipe skips a loop that no lane enters, and executes the body of every if.
    for (bool moves = useSmooth(); moves; moves = false) at = movedByChance(p, rng);
    return useTrilinear() ? trilinearEntry(at) : stochasticEntry(at, rng);
}

// The tables hold one entry for each stored value, linear between: a curve is exact at every value a voxel can have, and
// steps and bands narrower than one stored value are as wide as one.
float extinctionOfEntry(float entry) {
    if (!useTrilinear()) return fetchExtinction(int(entry));
    int low = int(entry);
    return mix(fetchExtinction(low), fetchExtinction(low + 1), entry - float(low));
}
