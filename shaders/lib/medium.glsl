// The optical medium at a point. Positions are in voxel coordinates with integers at voxel faces: the volume fills
// [0, size]; beyond the outermost centres the outer voxel goes on.
//
// Needs from its host: params.volumeSize, fetchStored(voxel) in table entries, fetchCorners(low, high,
// near, far): the same for the eight corners between two voxels that are at most 1 apart, blocksOfBrick(brick) and fetchFrom(blocks,
// voxel) for those of one brick and of the brick before it along each axis, fetchExtinction(entry) per mm, and
// useTrilinear(), useSmooth() and useSharp(), constants.

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

// A place that chance moves by up to a voxel along each axis, by the sum of two even numbers: on average over it what is trilinear
// is weighted by a cubic B-spline (a hat over a hat). One fetch, for what light is linear in (stochastic texture filtering,
// Pharr et al. 2024).
vec3 movedByChance(vec3 p, INOUT(Rng) rng) {
    vec3 first = random01Coarse3(rng);
    return p + first + random01Coarse3(rng) - vec3(1.0);
}

bool useSpline() {
    return useSmooth() || useSharp();
}

// What four voxels weigh at a fraction of the way from the second to the third: in a cubic B-spline (Unser, "Splines: a perfect
// fit", 1999), or in that of Mitchell and Netravali (1988), a third of the way there from that of Catmull and Rom, which goes
// through the values of the voxels.
vec4 splineWeights(float t) {
    float u = float(1.0) - t;
    vec4 soft = vec4(u * u * u, float(4.0) + t * t * (float(3.0) * t - float(6.0)), float(4.0) + u * u * (float(3.0) * u - float(6.0)),
                     t * t * t) * float(1.0 / 6.0);
    if (useSmooth()) return soft;
    vec4 through = vec4(-t * u * u, float(2.0) + t * t * (float(3.0) * t - float(5.0)),
                        float(2.0) + u * u * (float(3.0) * u - float(5.0)), -u * t * t) * float(0.5);
    return through + (soft - through) * float(1.0 / 3.0);
}

// The value at a point by a spline of the 4 x 4 x 4 voxels around. It has no kinks at the planes of voxels, which a steep curve
// would show as rings. No collision may draw one of these voxels instead: on average it would see what the curve makes of their
// values, not of the spline's. It is held to the least and the largest of them, which the sharp spline overshoots, and rounding of
// the other: so bounds of bricks are bounds of it, and nobody is shown a value that is not there.
float splineEntry(vec3 p) {
    ivec3 last = params.volumeSize - ivec3(1);
    vec3 q = p - vec3(0.5);
    ivec3 cell = ivec3(floor(q));
    vec3 f = q - vec3(cell);
    vec4 x = splineWeights(f.x);
    vec4 y = splineWeights(f.y);
    vec4 z = splineWeights(f.z);
    Blocks blocks = blocksOfBrick(clamp(cell + ivec3(2), ivec3(0), last) >> 3);
    int x0 = clamp(cell.x - 1, 0, last.x);
    int x1 = clamp(cell.x, 0, last.x);
    int x2 = clamp(cell.x + 1, 0, last.x);
    int x3 = clamp(cell.x + 2, 0, last.x);
    float sum = float(0.0);
    vec4 least = vec4(1e9);
    vec4 most = vec4(0.0);
    for (int k = 0; k < 4; ++k) {
        int atZ = clamp(cell.z - 1 + k, 0, last.z);
        for (int j = 0; j < 4; ++j) {
            int atY = clamp(cell.y - 1 + j, 0, last.y);
            vec4 row = vec4(fetchFrom(blocks, ivec3(x0, atY, atZ)), fetchFrom(blocks, ivec3(x1, atY, atZ)),
                            fetchFrom(blocks, ivec3(x2, atY, atZ)), fetchFrom(blocks, ivec3(x3, atY, atZ)));
            sum += dot(row, x) * (y[j] * z[k]);
            least = min(least, row);
            most = max(most, row);
        }
    }
    return clamp(sum, min(min(least.x, least.y), min(least.z, least.w)), max(max(most.x, most.y), max(most.z, most.w)));
}

// Without chance; of a stochastic value what it is on average.
float expectedEntry(vec3 p) {
    return useSpline() ? splineEntry(p) : trilinearEntry(p);
}

float entryAt(vec3 p, INOUT(Rng) rng) {
    return useTrilinear() ? expectedEntry(p) : stochasticEntry(p, rng);
}

// The tables hold one entry for each stored value, linear between: a curve is exact at every value a voxel can have, and
// steps and bands narrower than one stored value are as wide as one.
float extinctionOfEntry(float entry) {
    if (!useTrilinear()) return fetchExtinction(int(entry));
    int low = int(entry);
    return mix(fetchExtinction(low), fetchExtinction(low + 1), entry - float(low));
}
