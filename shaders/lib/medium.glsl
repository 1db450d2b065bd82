// The optical medium at a point. Positions are in voxel coordinates with integers at voxel faces: the volume
// fills [0, size]; beyond the outermost centres the outer voxels repeat.
//
// Needs from its host: params.volumeSize, fetchStored(voxel) in table entries, fetchCorners(low, high, near,
// far): the same for the eight corners between two voxels that are at most 1 apart, blocksOfBrick(brick) and
// fetchFrom(blocks, voxel) for those of one brick and of the brick before it along each axis,
// fetchExtinction(entry) per mm, and constants: useTrilinear(), false for the stochastic filter alone, and
// useSmooth() and useSharp(), of which one at most is true.

// The values of the eight voxels around a point, and its position between them.
struct Corners {
    vec4 near;      // at the low end of z: (low, low), (high, low), (low, high), (high, high) along x and y
    vec4 far;       // at the high end of z
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
               mix(mix(c.far.x, c.far.y, fraction.x), mix(c.far.z, c.far.w, fraction.x), fraction.y),
               fraction.z);
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

// The point jittered by up to a voxel along each axis, by the sum of two uniform numbers: a trilinear field
// averages over such points to a cubic B-spline (a hat convolved with a hat). It takes one fetch, and suits
// quantities that light is linear in (stochastic texture filtering, Pharr et al. 2024).
vec3 movedByChance(vec3 p, INOUT(Rng) rng) {
    vec3 first = random01Coarse3(rng);
    return p + first + random01Coarse3(rng) - vec3(1.0);
}

bool useSpline() {
    return useSmooth() || useSharp();
}

// The weights of four voxels at a fraction `t` of the way from the second to the third: for a cubic B-spline
// (Unser, "Splines: a perfect fit", 1999), or for Mitchell and Netravali's (1988), one third of it plus two
// thirds of Catmull and Rom's.
vec4 splineWeights(float t) {
    float u = float(1.0) - t;
    vec4 soft = vec4(u * u * u, float(4.0) + t * t * (float(3.0) * t - float(6.0)),
                     float(4.0) + u * u * (float(3.0) * u - float(6.0)), t * t * t) *
                float(1.0 / 6.0);
    if (useSmooth()) return soft;
    vec4 through = vec4(-t * u * u, float(2.0) + t * t * (float(3.0) * t - float(5.0)),
                        float(2.0) + u * u * (float(3.0) * u - float(5.0)), -u * t * t) *
                   float(0.5);
    return through + (soft - through) * float(1.0 / 3.0);
}

// The spline of four values, clamped to their range: Mitchell's overshoots it, the B-spline only by rounding.
float splined(vec4 values, vec4 weights) {
    return clamp(dot(values, weights), min(min(values.x, values.y), min(values.z, values.w)),
                 max(max(values.x, values.y), max(values.z, values.w)));
}

// The value at a point by a spline of the 4 x 4 x 4 voxels around: along x, then y, then z. It has no kinks
// at the planes of voxels, which a steep curve would show as rings. A collision must not draw one of these
// voxels at random instead: on average it would see the curve of their values, not the curve of the spline.
// It stays within the range of these voxels, so that the majorants of bricks hold. Each axis is clamped
// separately, so that the value does not jump from one cell to the next.
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
    vec4 layers = vec4(0.0);
    for (int k = 0; k < 4; ++k) {
        int atZ = clamp(cell.z - 1 + k, 0, last.z);
        vec4 rows = vec4(0.0);
        for (int j = 0; j < 4; ++j) {
            int atY = clamp(cell.y - 1 + j, 0, last.y);
            rows[j] =
                splined(vec4(fetchFrom(blocks, ivec3(x0, atY, atZ)), fetchFrom(blocks, ivec3(x1, atY, atZ)),
                             fetchFrom(blocks, ivec3(x2, atY, atZ)), fetchFrom(blocks, ivec3(x3, atY, atZ))),
                        x);
        }
        layers[k] = splined(rows, y);
    }
    return splined(layers, z);
}

// The value without randomness; for the stochastic filter its mean.
float expectedEntry(vec3 p) {
    return useSpline() ? splineEntry(p) : trilinearEntry(p);
}

float entryAt(vec3 p, INOUT(Rng) rng) {
    return useTrilinear() ? expectedEntry(p) : stochasticEntry(p, rng);
}

// The tables hold one entry for each stored value, and are linear between them: a curve is exact at every
// value that a voxel can have; a step or band narrower than one stored value becomes as wide as one.
float extinctionOfEntry(float entry) {
    if (!useTrilinear()) return fetchExtinction(int(entry));
    int low = int(entry);
    return mix(fetchExtinction(low), fetchExtinction(low + 1), entry - float(low));
}
