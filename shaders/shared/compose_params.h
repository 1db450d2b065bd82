// Push constants of shaders/hybrid/compose.comp.
#ifndef MACULA_SHARED_COMPOSE_PARAMS_H
#define MACULA_SHARED_COMPOSE_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

struct ComposePush {
    vec3 background;  // linear light, neither exposed nor tone-mapped
    float exposure;
    float splatGain;     // multiplies the light of splats, not their coverage
    float tracedShare;   // 0 to 1: weight of the full traced picture over splats and fovea
    int tracedAreMeans;  // 1: traced values are means, and counts are ignored
    int keepsHue;        // 1: toneMapHue, else toneMapNeutral
};

MACULA_SHARED_END
#endif
