// Gradients of values, and their effects on opacity and on matter.
//
// Needs, besides medium.glsl: params.voxelFromWorld*, and for gradient opacity useGradientOpacity(), a
// constant, params.gradientScale, params.gradientLast, params.unitDepthMm and fetchGradientOpacity(0 to
// gradientLast); for curves of steep matter useSteep() and useSteepDensity(), constants, the latter false
// only where both kinds of matter have the same extinctions; params.steepGradient,
// fetchSteepExtinction(entry) and fetchSteepMatter(entry).

// The gradient in table entries per mm along the world's axes, from central differences per voxel along the
// grid's axes; 0 where all values around are equal.
vec3 worldGradient(vec3 perVoxel) {
    // A difference below a twentieth of a stored value over two voxels is rounding of large values.
    if (!(dot(perVoxel, perVoxel) > float(0.000625))) return vec3(0.0);
    // A gradient in voxels becomes one in mm by the transpose of the map from mm to voxels.
    return vec3(dot(params.voxelFromWorldX, perVoxel), dot(params.voxelFromWorldY, perVoxel),
                dot(params.voxelFromWorldZ, perVoxel));
}

// The gradient at a point: central differences with a voxel to either side.
vec3 gradientAt(vec3 p) {
    vec3 x = vec3(float(1.0), float(0.0), float(0.0));
    vec3 y = vec3(float(0.0), float(1.0), float(0.0));
    vec3 z = vec3(float(0.0), float(0.0), float(1.0));
    return worldGradient(vec3(trilinearEntry(p + x) - trilinearEntry(p - x),
                              trilinearEntry(p + y) - trilinearEntry(p - y),
                              trilinearEntry(p + z) - trilinearEntry(p - z)) *
                         float(0.5));
}

// The gradient opacity, 0 to 1. Linear between the table's entries, which are evenly spaced over the length
// of the gradient; constant beyond the last.
float gradientOpacity(vec3 gradient) {
    float at = min(sqrt(dot(gradient, gradient)) * params.gradientScale, float(params.gradientLast));
    int low = min(int(at), params.gradientLast - 1);
    return mix(fetchGradientOpacity(low), fetchGradientOpacity(low + 1), at - float(low));
}

// The extinction per mm after gradient opacity. As in VTK, the opacities of a layer of the unit distance are
// multiplied. A gradient opacity is at most 1, so that majorants without it still hold.
float thinnedByGradient(float extinction, vec3 gradient) {
    float opacity = gradientOpacity(gradient) * (float(1.0) - exp(-extinction * params.unitDepthMm));
    return -log(float(1.0) - opacity) / params.unitDepthMm;
}

// The gradient at a voxel, from its neighbours; the outer voxels repeat beyond the volume.
vec3 gradientOfVoxel(ivec3 voxel) {
    ivec3 low = max(voxel - ivec3(1), ivec3(0));
    ivec3 high = min(voxel + ivec3(1), params.volumeSize - ivec3(1));
    return worldGradient(
        vec3(fetchStored(ivec3(high.x, voxel.y, voxel.z)) - fetchStored(ivec3(low.x, voxel.y, voxel.z)),
             fetchStored(ivec3(voxel.x, high.y, voxel.z)) - fetchStored(ivec3(voxel.x, low.y, voxel.z)),
             fetchStored(ivec3(voxel.x, voxel.y, high.z)) - fetchStored(ivec3(voxel.x, voxel.y, low.z))) *
        float(0.5));
}

// The gradient at one of the eight voxels around, drawn with its trilinear weight. Any function of a voxel's
// gradient then has the interpolated value on average, for six fetched voxels instead of forty-eight.
vec3 gradientByChance(vec3 p, INOUT(Rng) rng) {
    vec3 at = p;
    for (bool moves = useSmooth(); moves; moves = false) at = movedByChance(p, rng);
    ivec3 voxel = ivec3(floor(at - vec3(0.5) + random01Coarse3(rng)));
    return gradientOfVoxel(clamp(voxel, ivec3(0), params.volumeSize - ivec3(1)));
}

// The steep part of matter at this gradient, 0 to 1. It is interpolated between voxels, and extinctions are
// linear in it, so that a collision may draw it by gradientByChance().
float steepPart(vec3 gradient) {
    float length2 = dot(gradient, gradient);
    return length2 / max(length2 + params.steepGradient * params.steepGradient, float(1e-30));
}

float steepExtinctionOfEntry(float entry) {
    if (!useTrilinear()) return fetchSteepExtinction(int(entry));
    int low = int(entry);
    return mix(fetchSteepExtinction(low), fetchSteepExtinction(low + 1), entry - float(low));
}

// Whether extinction at this value depends on the steep part. Where only colours differ, flights need no
// gradient.
bool isSteepDenser(float entry) {
    return useSteepDensity() && steepExtinctionOfEntry(entry) != extinctionOfEntry(entry);
}

// The steep part at a point, drawn at random (exact: steepAt); 0 where extinction does not depend on it. A
// loop instead of an if, because lavapipe skips a loop that no lane enters, but executes the body of every
// if.
float steepByChance(vec3 p, float entry, INOUT(Rng) rng) {
    float part = float(0.0);
    for (bool asks = isSteepDenser(entry); asks; asks = false) part = steepPart(gradientByChance(p, rng));
    return part;
}

float steepOfAll(vec3 p) {
    ivec3 last = params.volumeSize - ivec3(1);
    vec3 q = clamp(p - vec3(0.5), vec3(0.0), vec3(last));
    ivec3 low = ivec3(q);
    vec3 f = q - vec3(low);
    float part = float(0.0);
    for (int i = 0; i < 8; ++i) {
        ivec3 step = ivec3(i & 1, (i >> 1) & 1, i >> 2);
        float weight = (step.x == 1 ? f.x : float(1.0) - f.x) * (step.y == 1 ? f.y : float(1.0) - f.y) *
                       (step.z == 1 ? f.z : float(1.0) - f.z);
        part += weight * steepPart(gradientOfVoxel(min(low + step, last)));
    }
    return min(part, float(1.0));  // rounded weights may sum to a little more
}

float steepAt(vec3 p, float entry) {
    float part = float(0.0);
    for (bool asks = isSteepDenser(entry); asks; asks = false) part = steepOfAll(p);
    return part;
}

// The extinctions per mm of flat and of steep matter, at a point with the value `entry`; equal unless steep
// matter has another density.
vec2 extinctionsAt(vec3 p, float entry) {
    vec2 both = vec2(extinctionOfEntry(entry));
    if (useSteepDensity()) both.y = steepExtinctionOfEntry(entry);
    if (useGradientOpacity()) {
        vec3 gradient = gradientAt(p);
        both.x = thinnedByGradient(both.x, gradient);
        both.y = useSteepDensity() ? thinnedByGradient(both.y, gradient) : both.x;
    }
    return both;
}

// The extinction per mm if the part `steep` of the matter is steep.
float extinctionAt(vec3 p, float entry, float steep) {
    vec2 both = extinctionsAt(p, entry);
    return useSteepDensity() ? mix(both.x, both.y, steep) : both.x;
}

// The share of the extinction due to steep matter, 0 to 1, if it is the part `steep` of the matter.
float steepShare(vec3 p, float entry, float steep) {
    if (!useSteepDensity()) return steep;
    vec2 both = extinctionsAt(p, entry);
    return both.y * steep / max(mix(both.x, both.y, steep), float(1e-20));
}
