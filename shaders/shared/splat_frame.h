// What the kernels that draw splats are told, and how what they pass on is laid out.
#ifndef MACULA_SHARED_SPLAT_FRAME_H
#define MACULA_SHARED_SPLAT_FRAME_H
#include "shared/splat_view.h"
MACULA_SHARED_BEGIN

// In a storage buffer, because it changes with every picture: see ARCHITECTURE.md, GPU.
struct SplatFrame {
    SplatView view;
    uint count;     // of splats
    uint capacity;  // of the arrays of their parameters, see splat_layout.h
    ivec2 tiles;    // of the picture: columns and rows of them
    int tileRows;   // pixels of a tile, from top to bottom
};

MACULA_SHARED_CONST int kTileColumns = 8;  // pixels of a tile, from left to right

// A splat in the picture takes so many vec4: mean, conic.xy | conic.z, opacity, depth, extent.x | colour,
// extent.y.
MACULA_SHARED_CONST int kScreenTexels = 3;

// What a tile tells about a splat: mean, conic, opacity, colour as in ScreenGradient; the sum of its weights;
// the sum over pixels of how strongly each pulls at the mean, so that pixels that pull against each other do
// not cancel.
MACULA_SHARED_CONST int kPairValues = 11;

// What is gathered of a splat over views, for deciding where more are needed and which are not.
struct SplatStatistics {
    float views;       // in which the splat showed
    float weight;      // sum of its blending weights over pixels and views
    float pull;        // sum over pixels of the absolute derivatives by its place in the picture, in pixels
    float mostWeight;  // the largest sum of its blending weights in one view
};

MACULA_SHARED_END
#endif
