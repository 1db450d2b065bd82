// The optical medium at a point. Positions are in voxel coordinates with integers at voxel faces: the volume fills
// [0, size]; beyond the outermost centres the outer voxel goes on.
//
// Needs from its host: params.volumeSize, fetchStored(voxel index) in table entries, fetchExtinction(entry) per mm, and
// useTrilinear(), a constant.

int voxelIndex(ivec3 voxel) {
    return (voxel.z * params.volumeSize.y + voxel.y) * params.volumeSize.x + voxel.x;
}

// The value at a point, as a continuous position in the tables.
float trilinearEntry(vec3 p) {
    vec3 q = clamp(p - vec3(0.5), vec3(0.0), vec3(params.volumeSize - ivec3(1)));
    ivec3 low = ivec3(q);
    vec3 f = q - vec3(low);
    ivec3 more = min(low + ivec3(1), params.volumeSize - ivec3(1)) - low;
    int i = voxelIndex(low);
    int dy = more.y * params.volumeSize.x;
    int dz = more.z * params.volumeSize.x * params.volumeSize.y;
    float near = mix(mix(fetchStored(i), fetchStored(i + more.x), f.x),
                     mix(fetchStored(i + dy), fetchStored(i + dy + more.x), f.x), f.y);
    i += dz;
    float far = mix(mix(fetchStored(i), fetchStored(i + more.x), f.x),
                    mix(fetchStored(i + dy), fetchStored(i + dy + more.x), f.x), f.y);
    return mix(near, far, f.z);
}

// One of the eight voxels around, drawn with its trilinear weight.
float stochasticEntry(vec3 p, INOUT(Rng) rng) {
    ivec3 voxel = ivec3(floor(p - vec3(0.5) + random01Coarse3(rng)));
    return fetchStored(voxelIndex(clamp(voxel, ivec3(0), params.volumeSize - ivec3(1))));
}

float entryAt(vec3 p, INOUT(Rng) rng) {
    return useTrilinear() ? trilinearEntry(p) : stochasticEntry(p, rng);
}

// The tables hold one entry for each stored value, linear between: a curve is exact at every value a voxel can have, and
// steps and bands narrower than one stored value are as wide as one.
float extinctionOfEntry(float entry) {
    if (!useTrilinear()) return fetchExtinction(int(entry));
    int low = int(entry);
    return mix(fetchExtinction(low), fetchExtinction(low + 1), entry - float(low));
}
