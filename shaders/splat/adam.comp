// One step of Adam for the splats that were seen. A thread for each splat.
//
// The loops skip what need not be done (an `if` would not, on lavapipe), and carry out of them only what texelFetch gave.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "shared/splat_adam_params.h"
#include "lib/splat_adam.glsl"

layout(local_size_x = 64) in;

layout(binding = 0, scalar) readonly buffer Params {
    SplatAdamParams params;
};
layout(binding = 1) uniform samplerBuffer corrections;  // by step
layout(binding = 2) uniform samplerBuffer gradients;    // these and the next by splat_layout.h
layout(binding = 3, scalar) readonly buffer Visible {
    uint visible[];
};
layout(binding = 4, scalar) buffer Parameters {
    float parameters[];
};
layout(binding = 5, scalar) buffer Firsts {
    float firsts[];
};
layout(binding = 6, scalar) buffer Seconds {
    float seconds[];
};
layout(binding = 7, scalar) buffer Steps {
    uint steps[];
};
layout(binding = 8, scalar) buffer Skipped {
    uint skipped;
};

void main() {
    uint splat = gl_GlobalInvocationID.x;
    if (splat >= params.count) return;
    bool seen = visible[splat] != 0u;
    int last = seen ? params.components : 0;
    bool usable = seen;
    for (int k = 0; k < last; ++k)
        usable = usable && isUsableGradient(texelFetch(gradients, int(uint(k) * params.capacity + splat)).x);

    for (int once = seen && !usable ? 1 : 0; once > 0; --once) atomicAdd(skipped, 1u);
    uint step = steps[splat] + 1u;
    vec2 correction = texelFetch(corrections, int(min(step, params.lastCorrection))).xy;
    last = usable ? params.components : 0;
    for (int k = 0; k < last; ++k) {
        uint at = uint(k) * params.capacity + splat;
        AdamStep next = adamStep(texelFetch(gradients, int(at)).x, firsts[at], seconds[at], correction, params.rates[k], params.beta1,
                                 params.beta2, params.epsilon);
        firsts[at] = next.first;
        seconds[at] = next.second;
        parameters[at] += next.change;
    }
    for (int once = usable ? 1 : 0; once > 0; --once) steps[splat] = step;
}
