// The parameters of splats, see shared/splat_layout.h. Needs: layout(constant_id = 0) const int kDegree.
layout(binding = 2) uniform samplerBuffer parameterTexels;

float fetchParameter(int component, int splat) {
    return texelFetch(parameterTexels, component * int(frame.capacity) + splat).x;
}

#include "lib/splat_parameters.glsl"
