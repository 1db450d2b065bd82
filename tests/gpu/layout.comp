#version 460
#extension GL_GOOGLE_include_directive : require
#include "test_struct.h"
// Copies a struct field by field, so that a wrong offset shows in the values as well.
layout(local_size_x = 1) in;

layout(binding = 0, scalar) readonly buffer Source {
    TestScene scene;
}
source;
layout(binding = 1, scalar) writeonly buffer Target {
    TestScene scene;
}
target;
layout(binding = 2, std140) uniform Misfit {
    vec3 a;
    float b;
    float list[2];
    vec2 c;
}
misfit;
layout(push_constant, scalar) uniform Push {
    TestLight light;
}
push;

void main() {
    target.scene.worldFromView = source.scene.worldFromView;
    target.scene.origin = source.scene.origin;
    target.scene.frame = source.scene.frame;
    target.scene.exposure = source.scene.exposure + misfit.b;
    target.scene.tint = source.scene.tint;
    target.scene.rotation = source.scene.rotation;
    target.scene.counts = source.scene.counts;
    target.scene.offset = source.scene.offset;
    for (uint i = 0u; i < kTestLights; ++i) target.scene.lights[i] = source.scene.lights[i];
    target.scene.lights[1] = push.light;
    target.scene.tail = source.scene.tail;
}
