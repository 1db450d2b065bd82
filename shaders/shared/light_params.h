// The hash table and the push constants of shaders/hybrid/lit.comp.
#ifndef MACULA_SHARED_LIGHT_PARAMS_H
#define MACULA_SHARED_LIGHT_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

// A slot of the hash table of cells: a key of 21 bits for each coordinate (x << 42 | y << 21 | z, each plus
// 2^20), and the index of the cell.
struct LightSlot {
    uint low;   // of the key
    uint high;  // all bits set: the slot is free
    uint cell;
};

MACULA_SHARED_CONST uint kFreeSlot = 0xffffffffu;

struct LitPush {
    vec3 right;  // half the width of the picture at distance 1
    vec3 up;     // half its height
    vec3 forward;
    ivec3 eyeCell;  // the cell of the eye
    vec3 eyePart;   // the eye's position in that cell, 0 to 1
    float cellsPerMm;
    ivec2 size;     // pixels
    int raysAside;  // rays along each side of a pixel
    int firstRow;   // of this dispatch
    uint slotMask;  // the number of slots, a power of two, less 1
};

MACULA_SHARED_END
#endif
