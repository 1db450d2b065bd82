// One step of Adam for the splats that showed in the view. A thread for each splat. Moments of a position are
// along the splat's axes, and its rate is relative to the standard deviations there (optimizer_options.h).
//
// The loops skip work (on lavapipe an `if` would not), and only results of texelFetch leave them.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "shared/splat_adam_params.h"
#include "lib/splat_adam.glsl"
#include "lib/splat_shape.glsl"

layout(local_size_x = 64) in;

layout(binding = 0, scalar) readonly buffer Params {
    SplatAdamParams params;
};
layout(binding = 1) uniform samplerBuffer corrections;  // by step
layout(binding = 2) uniform samplerBuffer gradients;    // like the next three in the layout of splat_layout.h
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

// Updates the moments at index `at`, and returns the change of the parameter.
float learnt(uint at, float gradient, float rate, vec2 correction) {
    AdamStep next = adamStep(gradient, firsts[at], seconds[at], correction, rate, params.beta1, params.beta2,
                             params.epsilon);
    firsts[at] = next.first;
    seconds[at] = next.second;
    return next.change;
}

float gradientAt(uint at) {
    return texelFetch(gradients, int(at)).x;
}

void movePosition(uint splat, vec2 correction) {
    uint n = params.capacity;
    uint scale = uint(kSplatLogScale) * n + splat;
    uint turn = uint(kSplatRotation) * n + splat;
    SplatAxes axes = axesOf(unitQuaternion(
        vec4(parameters[turn], parameters[turn + n], parameters[turn + 2u * n], parameters[turn + 3u * n])));
    vec3 rates = deviationsMm(vec3(parameters[scale], parameters[scale + n], parameters[scale + 2u * n])) *
                 params.rates[kSplatPosition];

    uint at = uint(kSplatPosition) * n + splat;
    vec3 gradient = alongAxes(axes, vec3(gradientAt(at), gradientAt(at + n), gradientAt(at + 2u * n)));
    vec3 change =
        vec3(learnt(at, gradient.x, rates.x, correction), learnt(at + n, gradient.y, rates.y, correction),
             learnt(at + 2u * n, gradient.z, rates.z, correction));
    vec3 moved = fromAxes(axes, change);
    parameters[at] += moved.x;
    parameters[at + n] += moved.y;
    parameters[at + 2u * n] += moved.z;
}

void main() {
    uint splat = gl_GlobalInvocationID.x;
    if (splat >= params.count) return;
    bool seen = visible[splat] != 0u;
    int last = seen ? params.components : 0;
    bool usable = seen;
    for (int k = 0; k < last; ++k)
        usable = usable && isUsableGradient(gradientAt(uint(k) * params.capacity + splat));

    for (int once = seen && !usable ? 1 : 0; once > 0; --once) atomicAdd(skipped, 1u);
    uint step = steps[splat] + 1u;
    vec2 correction = texelFetch(corrections, int(min(step, params.lastCorrection))).xy;
    // Positions first, along the axes for which the gradients were computed.
    for (int once = usable ? 1 : 0; once > 0; --once) movePosition(splat, correction);
    last = usable ? params.components : 0;
    for (int k = kSplatLogScale; k < last; ++k) {
        uint at = uint(k) * params.capacity + splat;
        parameters[at] += learnt(at, gradientAt(at), params.rates[k], correction);
    }
    for (int once = usable ? 1 : 0; once > 0; --once) steps[splat] = step;
}
