// How values change around a point, and what that does to opacity.
//
// Needs, beside medium.glsl: params.voxelFromWorld*, and for gradient opacity useGradientOpacity(), a
// constant, params.gradientScale, params.gradientLast, params.unitDepthMm and fetchGradientOpacity(0 to
// gradientLast); for curves of steep matter useSteep() and useSteepDensity(), constants, the latter false
// only where both kinds of matter have the same extinctions; params.steepGradient,
// fetchSteepExtinction(entry) and fetchSteepMatter(entry).

// The gradient in table entries per mm along the axes of the world, from half the differences between two
// voxels apart along the axes of the grid; 0 where the values are all the same.
vec3 worldGradient(vec3 perVoxel) {
    // A twentieth of a stored value over two voxels is rounding of large values.
    if (!(dot(perVoxel, perVoxel) > float(0.000625))) return vec3(0.0);
    // A gradient in voxels becomes one in mm by the transpose of the map from mm to voxels.
    return vec3(dot(params.voxelFromWorldX, perVoxel), dot(params.voxelFromWorldY, perVoxel),
                dot(params.voxelFromWorldZ, perVoxel));
}

// The gradient of the value: central differences over a voxel to either side.
vec3 gradientAt(vec3 p) {
    vec3 x = vec3(float(1.0), float(0.0), float(0.0));
    vec3 y = vec3(float(0.0), float(1.0), float(0.0));
    vec3 z = vec3(float(0.0), float(0.0), float(1.0));
    return worldGradient(vec3(trilinearEntry(p + x) - trilinearEntry(p - x),
                              trilinearEntry(p + y) - trilinearEntry(p - y),
                              trilinearEntry(p + z) - trilinearEntry(p - z)) *
                         float(0.5));
}

// The gradient opacity, 0 to 1. The table is linear between its entries, which are evenly spaced over the
// length of the gradient; beyond the last one it goes on as it ends.
float gradientOpacity(vec3 gradient) {
    float at = min(sqrt(dot(gradient, gradient)) * params.gradientScale, float(params.gradientLast));
    int low = min(int(at), params.gradientLast - 1);
    return mix(fetchGradientOpacity(low), fetchGradientOpacity(low + 1), at - float(low));
}

// What a gradient leaves of an extinction, both per mm. Opacities multiply, as in VTK: those of a layer of
// the unit distance. A gradient opacity is at most 1: bounds of the extinction of values are bounds of this
// too.
float thinnedByGradient(float extinction, vec3 gradient) {
    float opacity = gradientOpacity(gradient) * (float(1.0) - exp(-extinction * params.unitDepthMm));
    return -log(float(1.0) - opacity) / params.unitDepthMm;
}

// The gradient at a voxel, from its neighbours; beyond the outer voxels the volume goes on.
vec3 gradientOfVoxel(ivec3 voxel) {
    ivec3 low = max(voxel - ivec3(1), ivec3(0));
    ivec3 high = min(voxel + ivec3(1), params.volumeSize - ivec3(1));
    return worldGradient(
        vec3(fetchStored(ivec3(high.x, voxel.y, voxel.z)) - fetchStored(ivec3(low.x, voxel.y, voxel.z)),
             fetchStored(ivec3(voxel.x, high.y, voxel.z)) - fetchStored(ivec3(voxel.x, low.y, voxel.z)),
             fetchStored(ivec3(voxel.x, voxel.y, high.z)) - fetchStored(ivec3(voxel.x, voxel.y, low.z))) *
        float(0.5));
}

// The gradient at one of the eight voxels around, drawn with its trilinear weight. So what is linear in
// something of a voxel's gradient is on average as if that were interpolated, and takes six voxels, not
// forty-eight.
vec3 gradientByChance(vec3 p, INOUT(Rng) rng) {
    vec3 at = p;
    for (bool moves = useSmooth(); moves; moves = false) at = movedByChance(p, rng);
    ivec3 voxel = ivec3(floor(at - vec3(0.5) + random01Coarse3(rng)));
    return gradientOfVoxel(clamp(voxel, ivec3(0), params.volumeSize - ivec3(1)));
}

// The part of matter that is steep where the gradient is this, 0 to 1. Between voxels that part is trilinear:
// extinctions are linear in it, so that a collision may draw it by gradientByChance().
float steepPart(vec3 gradient) {
    float length2 = dot(gradient, gradient);
    return length2 / max(length2 + params.steepGradient * params.steepGradient, float(1e-30));
}

float steepExtinctionOfEntry(float entry) {
    if (!useTrilinear()) return fetchSteepExtinction(int(entry));
    int low = int(entry);
    return mix(fetchSteepExtinction(low), fetchSteepExtinction(low + 1), entry - float(low));
}

// Whether it matters to the extinction at this value what part is steep. Where only colours differ, flights
// ask for no gradient.
bool isSteepDenser(float entry) {
    return useSteepDensity() && steepExtinctionOfEntry(entry) != extinctionOfEntry(entry);
}

// The steep part at a point, drawn and exact; 0 where it does not matter to the extinction. lavapipe skips a
// loop that no lane enters, and executes the body of every if.
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
    return min(part, float(1.0));  // weights may add to a little more
}

float steepAt(vec3 p, float entry) {
    float part = float(0.0);
    for (bool asks = isSteepDenser(entry); asks; asks = false) part = steepOfAll(p);
    return part;
}

// The extinctions per mm of flat and of steep matter, at a point where the value is `entry`; the same where
// curves are.
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

// The extinction per mm, where that part of the matter is steep.
float extinctionAt(vec3 p, float entry, float steep) {
    vec2 both = extinctionsAt(p, entry);
    return useSteepDensity() ? mix(both.x, both.y, steep) : both.x;
}

// What of the extinction steep matter has, where it is that part of the matter; 0 to 1.
float steepShare(vec3 p, float entry, float steep) {
    if (!useSteepDensity()) return steep;
    vec2 both = extinctionsAt(p, entry);
    return both.y * steep / max(mix(both.x, both.y, steep), float(1e-20));
}
