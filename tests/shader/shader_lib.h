// shaders/lib in C++ without tables, in float and in double, for tests of its pure functions.
#pragma once

#include "base/glsl_in_cpp.h"
#include "shared/trace_params.h"

#define OUT(type) type&
#define INOUT(type) type&
#define PRECISE
#define PI 3.14159265358979323846

namespace macula {

struct ShaderLibSingle : GlslInCpp<float> {
    static constexpr uint kNetSamples = shared::kNetSamples;
#include "lib/fovea.glsl"
#include "lib/net.glsl"
#include "lib/phase.glsl"
#include "lib/picture.glsl"
#include "lib/rng.glsl"
};

struct ShaderLibTwofold : GlslInCpp<double> {
    static constexpr uint kNetSamples = shared::kNetSamples;
#define float double
#include "lib/fovea.glsl"
#include "lib/net.glsl"
#include "lib/phase.glsl"
#include "lib/picture.glsl"
#include "lib/rng.glsl"
#undef float
};

}  // namespace macula

#undef OUT
#undef INOUT
#undef PRECISE
#undef PI
