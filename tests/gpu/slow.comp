#version 460
// Takes long enough that the host can get ahead of it.
layout(local_size_x = 64) in;
layout(binding = 0, std430) readonly buffer In {
    uint values[];
}
source;
layout(binding = 1, std430) buffer Out {
    uint values[];
}
result;
layout(push_constant) uniform Push {
    uint rounds;
}
push;

void main() {
    uint i = gl_GlobalInvocationID.x;
    uint state = source.values[i];
    for (uint k = 0u; k < push.rounds; ++k) state = state * 747796405u + 2891336453u;
    result.values[i] += state;
}
