// What shaders/lib needs from its host, on the GPU: tables in texel buffers, which are by far the fastest read-only
// arrays on CPU devices and as good as any on others. The C++ counterpart is src/pipeline/trace/reference_host.inl.
#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise

#include "shared/trace_params.h"

layout(constant_id = 0) const bool kTrilinear = true;
layout(constant_id = 2) const bool kClip = false;

// Not a uniform block: lavapipe (Mesa 22.3) compiles a uniform that decides a branch into the shader, and so would compile
// anew, for a tenth of a second, whenever the camera moves.
layout(binding = 0, scalar) readonly buffer Params {
    TraceParams params;
};
layout(binding = 1) uniform usamplerBuffer entryTexels;       // voxels, as positions in the tables
layout(binding = 2) uniform samplerBuffer extinctionTexels;   // per mm, by entry
layout(binding = 3) uniform samplerBuffer albedoTexels;       // by entry
layout(binding = 4) uniform samplerBuffer boundTexels;        // by brick
layout(binding = 5) uniform samplerBuffer environmentTexels;  // radiance and pdf per steradian, by texel
layout(binding = 6) uniform samplerBuffer aliasTexels;        // probability to stay, and the other texel

float fetchStored(int voxel) {
    return float(texelFetch(entryTexels, voxel).x);
}
float fetchExtinction(int entry) {
    return texelFetch(extinctionTexels, entry).x;
}
vec3 fetchAlbedo(int entry) {
    return texelFetch(albedoTexels, entry).xyz;
}
float fetchBound(int brick) {
    return texelFetch(boundTexels, brick).x;
}
vec4 fetchEnvironment(int texel) {
    return texelFetch(environmentTexels, texel);
}
vec2 fetchAlias(int texel) {
    return texelFetch(aliasTexels, texel).xy;
}
bool useTrilinear() {
    return kTrilinear;
}
bool useClip() {
    return kClip;
}

#include "lib/trace_lib.glsl"
