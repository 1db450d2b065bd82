// Whether the mask hides a point. A mask has a bit for each voxel, interpolated between voxels; it shows from
// one half on, so that its faces are smooth and not made of voxels.
//
// Needs from its host: params.volumeSize, fetchMask(voxel), 1 where it is shown, and useMask(), a constant.

bool isMasked(vec3 p) {
    if (!useMask()) return false;
    vec3 q = clamp(p - vec3(0.5), vec3(0.0), vec3(params.volumeSize - ivec3(1)));
    ivec3 low = ivec3(q);
    ivec3 high = min(low + ivec3(1), params.volumeSize - ivec3(1));
    vec3 f = q - vec3(low);
    float near =
        mix(mix(fetchMask(low), fetchMask(ivec3(high.x, low.y, low.z)), f.x),
            mix(fetchMask(ivec3(low.x, high.y, low.z)), fetchMask(ivec3(high.x, high.y, low.z)), f.x), f.y);
    float far = mix(mix(fetchMask(ivec3(low.x, low.y, high.z)), fetchMask(ivec3(high.x, low.y, high.z)), f.x),
                    mix(fetchMask(ivec3(low.x, high.y, high.z)), fetchMask(high), f.x), f.y);
    return mix(near, far, f.z) < float(0.5);
}
