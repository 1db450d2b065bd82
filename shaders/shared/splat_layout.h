// Where the parameters of splats lie on the device: for parameters, their gradients and the optimiser's
// moments alike.
//
// One float array of components; component k of splat i is at k * capacity + i, so that neighbouring threads,
// a splat each, read neighbouring numbers. For their meaning see src/pipeline/splat/model/splats.h.
#ifndef MACULA_SHARED_SPLAT_LAYOUT_H
#define MACULA_SHARED_SPLAT_LAYOUT_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

MACULA_SHARED_CONST int kSplatPosition = 0;  // x, y, z in mm
MACULA_SHARED_CONST int kSplatLogScale = 3;  // of the splat's three axes
MACULA_SHARED_CONST int kSplatRotation = 6;  // w, x, y, z
MACULA_SHARED_CONST int kSplatOpacity = 10;  // logit
MACULA_SHARED_CONST int kSplatDc = 11;       // red, green, blue
MACULA_SHARED_CONST int kSplatSh = 14;       // red, green, blue of each coefficient of degree 1 and above
MACULA_SHARED_CONST int kMaxSplatComponents = 59;  // at degree 3

MACULA_SHARED_END
#endif
