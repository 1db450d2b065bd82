// The depths of eight layers of matter along the centre ray of a pixel: see shaders/lib/layers.glsl.
#ifndef MACULA_SHARED_PIXEL_LAYERS_H
#define MACULA_SHARED_PIXEL_LAYERS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

MACULA_SHARED_CONST int kPixelLayers = 8;

struct PixelLayers {
    vec4 nearMm;  // distance along the centre ray at which opacity reaches 1/16, 3/16, 5/16, 7/16; negative:
                  // never
    vec4 farMm;   // likewise 9/16, 11/16, 13/16, 15/16
    float coverage;
    float meanMm;  // mean distance of the matter down to transmittance 1/2; negative: no matter
};

struct LayersPush {
    int firstRow;  // of this dispatch
};

MACULA_SHARED_END
#endif
