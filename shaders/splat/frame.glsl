// What all kernels that draw splats begin with.
#extension GL_EXT_control_flow_attributes : require
#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise

#include "shared/splat_frame.h"
#include "shared/splat_layout.h"

// Not a uniform block: lavapipe would compile it into the shader, anew for each picture.
layout(binding = 0, scalar) readonly buffer Frame {
    SplatFrame frame;
};

#include "lib/splat_lib.glsl"
