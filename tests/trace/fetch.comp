// Reads every voxel as the tracer does: alone, and as a corner of the cell above it.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "trace/host.glsl"

layout(local_size_x = 64) in;

layout(binding = 16, scalar) writeonly buffer Found {
    vec2 found[];  // by voxel: its entry; and how many of the cell's corners differ from what is read alone
};

void main() {
    int index = int(gl_GlobalInvocationID.x);
    ivec3 size = params.volumeSize;
    if (index >= size.x * size.y * size.z) return;
    ivec3 low = ivec3(index % size.x, index / size.x % size.y, index / size.x / size.y);
    ivec3 high = min(low + ivec3(1), size - ivec3(1));
    vec4 near;
    vec4 far;
    fetchCorners(low, high, near, far);
    vec4 nearAlone =
        vec4(fetchStored(low), fetchStored(ivec3(high.x, low.y, low.z)),
             fetchStored(ivec3(low.x, high.y, low.z)), fetchStored(ivec3(high.x, high.y, low.z)));
    vec4 farAlone = vec4(fetchStored(ivec3(low.x, low.y, high.z)), fetchStored(ivec3(high.x, low.y, high.z)),
                         fetchStored(ivec3(low.x, high.y, high.z)), fetchStored(high));
    vec4 wrong = vec4(notEqual(near, nearAlone)) + vec4(notEqual(far, farAlone));
    found[index] = vec2(fetchStored(low), dot(wrong, vec4(1.0)));
}
