#version 460
// out[i] = stored[i] * scale + table[i % 4] + kBias: texel buffers, a storage buffer, push and specialization
// constants.
layout(local_size_x_id = 0) in;
layout(constant_id = 1) const float kBias = 0.5;
layout(constant_id = 2) const bool kNegate = false;

layout(binding = 0) uniform usamplerBuffer stored;
layout(binding = 2) uniform samplerBuffer table;
layout(binding = 5, std430) writeonly buffer Out {
    float values[];
}
result;

layout(push_constant) uniform Push {
    uint count;
    float scale;
}
push;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= push.count) return;
    float value = float(texelFetch(stored, int(i)).r) * push.scale + texelFetch(table, int(i % 4u)).r + kBias;
    result.values[i] = kNegate ? -value : value;
}
