// Declarations that all kernels that draw splats share.
#extension GL_EXT_control_flow_attributes : require
#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise

#include "shared/splat_frame.h"
#include "shared/splat_layout.h"

// Not a uniform block: lavapipe would compile its values into the shader, again for each picture.
layout(binding = 0, scalar) readonly buffer Frame {
    SplatFrame frame;
};

#include "lib/splat_lib.glsl"
