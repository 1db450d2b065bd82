#version 460
// Search loops in the forms that Mesa 22.3.6 compiles rightly, to be used in all our kernels. See
// lavapipe_test.cpp.
layout(local_size_x = 64) in;
layout(constant_id = 0) const uint kForm = 0u;

layout(binding = 0, std430) readonly buffer Values {
    float at[];
}
values;
layout(binding = 1, std430) readonly buffer Starts {
    uint at[];
}
starts;
layout(binding = 2, std430) writeonly buffer Found {
    float at[];
}
found;
layout(push_constant) uniform Push {
    uint count;
    uint searches;
    float threshold;
}
push;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= push.searches) return;
    uint k = starts.at[i];
    float value = -1.0;
    if (kForm == 0u) {
        // Only the index leaves the loop; the value is loaded again.
        while (k + 1u < push.count && values.at[k] <= push.threshold) ++k;
        value = values.at[k];
    } else if (kForm == 1u) {
        bool done = false;
        while (!done) {
            float candidate = values.at[k];
            if (candidate > push.threshold || k + 1u >= push.count) {
                value = candidate;
                done = true;
            }
            ++k;
        }
    } else {
        for (uint n = k; n < push.count; ++n) {
            float candidate = values.at[n];
            if (candidate > push.threshold || n + 1u >= push.count) {
                value = candidate;
                break;
            }
        }
    }
    found.at[i] = value;
}
