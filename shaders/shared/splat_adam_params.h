// Parameters of the optimiser's kernel (shaders/splat/adam.comp).
#ifndef MACULA_SHARED_SPLAT_ADAM_PARAMS_H
#define MACULA_SHARED_SPLAT_ADAM_PARAMS_H
#include "shared/splat_layout.h"
MACULA_SHARED_BEGIN

struct SplatAdamParams {
    uint count;     // of splats
    uint capacity;  // of the arrays
    int components;
    uint lastCorrection;  // index of the table's last entry, which all later steps use too
    float beta1;
    float beta2;
    float epsilon;
    float rates[kMaxSplatComponents];  // learning rates, by component
};

MACULA_SHARED_END
#endif
