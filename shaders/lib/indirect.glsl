// The cache of indirect light: the light that reaches the first vertices of paths from other matter, averaged
// over all directions, by position. It varies slowly in space, and is the larger part of a path's cost and of
// its noise. Cells are found by a hash of their coordinates, and looked up at a position jittered by up to
// half a cell: on average this is linear interpolation (Binder, Fricke and Keller 2019, "Massively Parallel
// Path Space Filtering").
//
// A cell also has a side, the axis along which the eye looks, so that both faces of a wall thinner than a
// cell have their own light. Where the phase function is not isotropic, the light is valid for that side
// only. And it has a kind of matter, by albedo and extinction: a calcification smaller than a cell must not
// get the light of the dark matter around it.
//
// Needs: useIndirect(), a constant; fetchIndirectTags(bucket) and fetchIndirectCell(cell), see
// shared/indirect_light.h; params.indirect*.

// A path ends at a cell with n samples with the probability n / (n + this).
#define INDIRECT_DOUBT 8.0
#define INDIRECT_LEVELS 15  // the largest cell has 2^15 times the width of the smallest
// A cell's light is averaged with that of the cell 2^INDIRECT_WIDER times as wide, which counts for up to
// INDIRECT_PRIOR samples.
#define INDIRECT_WIDER 2
#define INDIRECT_PRIOR 8.0
#define INDIRECT_BRIGHTS 6.0  // number of kinds by albedo, from black to white
#define INDIRECT_OCTAVES 3.0  // each kind by extinction is 2^this times as dense as the last

// The level of cells at a position: they are 2^level times as wide as the smallest.
int indirectLevel(vec3 at) {
    vec3 fromEye = (at - params.originVoxel) * params.indirectCellsPerVoxel;
    float width =
        params.indirectWidth * (params.parallelMm > float(0.0) ? float(1.0) : sqrt(dot(fromEye, fromEye)));
    int level = 0;
    for (float w = float(2.0); w <= width && level < INDIRECT_LEVELS; w *= float(2.0)) level += 1;
    return level;
}

// The side, of six, that a ray in this direction sees.
int indirectSide(vec3 direction) {
    vec3 along = direction * direction;
    if (along.x >= max(along.y, along.z)) return direction.x < float(0.0) ? 1 : 0;
    if (along.y >= along.z) return direction.y < float(0.0) ? 3 : 2;
    return direction.z < float(0.0) ? 5 : 4;
}

// The kind of matter as two continuous coordinates: by albedo, and by extinction per mm.
vec2 indirectMatter(vec3 albedo, float extinction) {
    float bright = max(albedo.x, max(albedo.y, albedo.z));
    return vec2(bright * float(INDIRECT_BRIGHTS),
                (log2(max(extinction, float(1e-6))) + float(10.0)) / float(INDIRECT_OCTAVES));
}

// Bucket and tag of the cell at `place` (in cells of this level), for this side and the nearest kind of
// matter.
uvec2 indirectCell(vec3 place, int level, int side, vec2 matter) {
    vec3 low = floor(clamp(place, vec3(0.0), vec3(65534.0)));
    vec2 kind = floor(clamp(matter + vec2(0.5), vec2(0.0), vec2(15.0)));
    uint a = (uint(low.x) << 16u) | uint(low.y);
    uint b = (uint(low.z) << 16u) | (uint(level) << 11u) | (uint(kind.x) << 7u) | (uint(kind.y) << 3u) |
             uint(side);
    return uvec2(hashOf(a, b) & (kIndirectBuckets - 1u), hashOf(b ^ 0x5bd1e995u, a) | 1u);
}

// Mean light and number of samples of a cell; 0 if it is not in the cache.
vec4 indirectIn(uvec2 cell) {
    uvec4 tags = fetchIndirectTags(int(cell.x));
    int way =
        tags.x == cell.y ? 0 : (tags.y == cell.y ? 1 : (tags.z == cell.y ? 2 : (tags.w == cell.y ? 3 : -1)));
    if (way < 0) return vec4(0.0);
    uvec4 sums = fetchIndirectCell(int(cell.x * kIndirectWays) + way);
    float scale = params.indirectUnit / max(float(sums.w), float(1.0));
    return vec4(float(sums.x) * scale, float(sums.y) * scale, float(sums.z) * scale, float(sums.w));
}

// The light at `at` from cells of this level, on average interpolated linearly. `own` is the cell that
// contains the position.
vec4 indirectOfLevel(vec3 at, int level, int side, vec2 matter, INOUT(Rng) rng, OUT(uvec2) own) {
    vec3 place = at * params.indirectCellsPerVoxel / float(1 << level) +
                 vec3(1.0);  // so that jitter cannot make it negative
    own = indirectCell(place, level, side, matter);
    vec4 here = indirectIn(own);
    vec3 aside = random01Coarse3(rng) - vec3(0.5);
    vec2 other = vec2(random01Coarse3(rng)) - vec2(0.5);
    vec4 there = indirectIn(indirectCell(place + aside, level, side, matter + other));
    // Prefers cells with more samples: those with few lie outside the surface, or far behind it where it is
    // darker.
    return random01(rng) * here.w < there.w ? there : here;
}

// The light at a vertex in matter of this kind, for a path that arrives along `direction`; w is the number of
// samples that it is worth. `own` are the cells that contain the vertex.
vec4 indirectAt(vec3 at, vec3 direction, vec2 matter, INOUT(Rng) rng, OUT(uvec4) own) {
    int level = indirectLevel(at);
    int side = indirectSide(direction);
    uvec2 narrow;
    uvec2 wide;
    vec4 near = indirectOfLevel(at, level, side, matter, rng, narrow);
    vec4 around = indirectOfLevel(at, level + INDIRECT_WIDER, side, matter, rng, wide);
    own = uvec4(narrow, wide);
    float prior = min(around.w, float(INDIRECT_PRIOR));
    float counts = max(near.w + prior, float(1.0));
    return vec4((vec3(near) * near.w + vec3(around) * prior) / counts, near.w + prior);
}
