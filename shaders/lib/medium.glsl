// The optical medium at a point. Positions are in voxel coordinates with integers at voxel faces: the volume
// fills [0, size]; beyond the outermost centres the outer voxel goes on.
//
// Needs from its host: params.volumeSize, fetchStored(voxel) in table entries, fetchCorners(low, high,
// near, far): the same for the eight corners between two voxels that are at most 1 apart,
// blocksOfBrick(brick) and fetchFrom(blocks, voxel) for those of one brick and of the brick before it along
// each axis, fetchExtinction(entry) per mm, and constants: useTrilinear(), false for the stochastic filter
// alone, and useSmooth() and useSharp(), of which one at most is true.

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

// A place that chance moves by up to a voxel along each axis, by the sum of two even numbers: the average of
// a trilinear field over such places is a cubic B-spline's (a hat over a hat). One fetch, for what light is
// linear in (stochastic texture filtering, Pharr et al. 2024).
vec3 movedByChance(vec3 p, INOUT(Rng) rng) {
    vec3 first = random01Coarse3(rng);
    return p + first + random01Coarse3(rng) - vec3(1.0);
}

bool useSpline() {
    return useSmooth() || useSharp();
}

// What four voxels weigh at a fraction of the way from the second to the third: in a cubic B-spline (Unser,
// "Splines: a perfect fit", 1999), or in Mitchell and Netravali's (1988), which is a third of that and two
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

// What four values make in a spline, within their range: Mitchell's overshoots it, the B-spline only by
// rounding.
float splined(vec4 values, vec4 weights) {
    return clamp(dot(values, weights), min(min(values.x, values.y), min(values.z, values.w)),
                 max(max(values.x, values.y), max(values.z, values.w)));
}

// The value at a point by a spline of the 4 x 4 x 4 voxels around: along x, then y, then z. It has no kinks
// at the planes of voxels, which a steep curve would show as rings. No collision may draw one of these voxels
// instead: on average it would see what the curve makes of their values, not of the spline's. It stays within
// the range of these voxels, so bounds of bricks are bounds of it. Each axis is clamped by itself: so the
// value does not jump from one cell to the next.
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

// Without chance; of a stochastic value what it is on average.
float expectedEntry(vec3 p) {
    return useSpline() ? splineEntry(p) : trilinearEntry(p);
}

float entryAt(vec3 p, INOUT(Rng) rng) {
    return useTrilinear() ? expectedEntry(p) : stochasticEntry(p, rng);
}

// The tables hold one entry for each stored value, linear between: a curve is exact at every value a voxel
// can have, and steps and bands narrower than one stored value are as wide as one.
float extinctionOfEntry(float entry) {
    if (!useTrilinear()) return fetchExtinction(int(entry));
    int low = int(entry);
    return mix(fetchExtinction(low), fetchExtinction(low + 1), entry - float(low));
}
