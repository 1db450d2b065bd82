// The primary vertex of a sample: where its path first met matter, and the light from there.
#ifndef MACULA_SHARED_PRIMARY_VERTEX_H
#define MACULA_SHARED_PRIMARY_VERTEX_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

// The samples of a pixel whose primary vertices are kept. A picture of 1400 x 1400 then takes 94 MB, which
// every device allows in one buffer.
MACULA_SHARED_CONST uint kPrimarySamples = 2u;

struct PrimaryVertex {
    vec3 fromEyeMm;  // world axes; 0 if the path met nothing or was lost
    vec3 radiance;   // linear, that left there towards the eye
};

MACULA_SHARED_END
#endif
