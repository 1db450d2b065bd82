// What shaders/hybrid/compose.comp is told.
#ifndef MACULA_SHARED_COMPOSE_PARAMS_H
#define MACULA_SHARED_COMPOSE_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

struct ComposePush {
    vec3 background;  // in linear light, displayed as it is
    float exposure;
    float splatGain;     // multiplies the light of splats, not their coverage
    float tracedShare;   // 0 to 1: of what is traced with all pixels; the rest is of splats and fovea
    int tracedAreMeans;  // 1: traced values are means, and counts do not count
    int keepsHue;        // 1: toneMapHue, else toneMapNeutral
};

MACULA_SHARED_END
#endif
