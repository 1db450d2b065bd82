#version 460
// How many rounds do loops really run? One loop of `once`, then `outer` x `inner`.
layout(local_size_x = 8) in;
layout(binding = 0, std430) writeonly buffer Out {
    uint rounds[];
}
result;
layout(push_constant) uniform Push {
    uint once;
    uint outer;
    uint inner;
}
push;

void main() {
    uint a = 0u;
    for (uint k = 0u; k < push.once; ++k) a = a * 3u + 1u - 2u * a;  // a + 1, but not known to be
    uint b = 0u;
    for (uint i = 0u; i < push.outer; ++i)
        for (uint k = 0u; k < push.inner; ++k) b = b * 3u + 1u - 2u * b;
    if (gl_LocalInvocationID.x == 0u) {
        result.rounds[0] = a;
        result.rounds[1] = b;
    }
}
