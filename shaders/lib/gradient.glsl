// How values change around a point, and what that does to opacity.
//
// Needs, beside medium.glsl: params.voxelFromWorld*, and for gradient opacity useGradientOpacity(), a constant,
// params.gradientScale, params.gradientLast, params.unitDepthMm and fetchGradientOpacity(0 to gradientLast).

// The gradient in table entries per mm along the axes of the world, from half the differences between two voxels apart
// along the axes of the grid; 0 where the values are all the same.
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
    return worldGradient(vec3(trilinearEntry(p + x) - trilinearEntry(p - x), trilinearEntry(p + y) - trilinearEntry(p - y),
                              trilinearEntry(p + z) - trilinearEntry(p - z)) * float(0.5));
}

// The gradient opacity, 0 to 1. The table is linear between its entries, which are evenly spaced over the length of the
// gradient; beyond the last one it goes on as it ends.
float gradientOpacity(vec3 gradient) {
    float at = min(sqrt(dot(gradient, gradient)) * params.gradientScale, float(params.gradientLast));
    int low = min(int(at), params.gradientLast - 1);
    return mix(fetchGradientOpacity(low), fetchGradientOpacity(low + 1), at - float(low));
}

// What a gradient leaves of an extinction, both per mm. Opacities multiply, as in VTK: those of a layer of the unit distance. A
// gradient opacity is at most 1: bounds of the extinction of values are bounds of this too.
float thinnedByGradient(float extinction, vec3 gradient) {
    float opacity = gradientOpacity(gradient) * (float(1.0) - exp(-extinction * params.unitDepthMm));
    return -log(float(1.0) - opacity) / params.unitDepthMm;
}

// The extinction per mm, at a point where the value is `entry`.
float extinctionAt(vec3 p, float entry) {
    float extinction = extinctionOfEntry(entry);
    return useGradientOpacity() ? thinnedByGradient(extinction, gradientAt(p)) : extinction;
}
