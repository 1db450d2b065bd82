// A shared header as shaders/shared/*.h are, with every type that may stand in one.
#ifndef MACULA_TEST_STRUCT_H
#define MACULA_TEST_STRUCT_H

#include "shared/shared.h"

MACULA_SHARED_BEGIN

MACULA_SHARED_CONST uint kTestLights = 3u;

struct TestLight {
    vec3 direction;
    float intensity;
    vec3 colour;
    uint flags;
    vec2 size;
};

struct TestScene {
    mat4 worldFromView;
    vec3 origin;
    uint frame;
    float exposure;
    vec4 tint;
    mat3 rotation;
    uvec3 counts;
    ivec2 offset;
    TestLight lights[kTestLights];
    float tail;
};

MACULA_SHARED_END

#endif
