// Parameters of the kernels that draw splats, and the layout of the data that they pass on.
#ifndef MACULA_SHARED_SPLAT_FRAME_H
#define MACULA_SHARED_SPLAT_FRAME_H
#include "shared/splat_view.h"
MACULA_SHARED_BEGIN

// In a storage buffer, because it changes with every picture: see ARCHITECTURE.md, GPU.
struct SplatFrame {
    SplatView view;
    uint count;     // of splats
    uint capacity;  // of the arrays of their parameters, see splat_layout.h
    ivec2 tiles;    // columns and rows of tiles in the picture
    int tileRows;   // pixels of a tile, from top to bottom
};

MACULA_SHARED_CONST int kTileColumns = 8;  // pixels of a tile, from left to right

// A projected splat takes so many vec4: mean, conic.xy | conic.z, opacity, depth, extent.x | colour,
// extent.y.
MACULA_SHARED_CONST int kScreenTexels = 3;

// The values that a tile sums for a splat: gradients of mean, conic, opacity and colour as in ScreenGradient;
// the splat's blending weights; and the absolute pull of each pixel on the mean, so that opposite pulls do
// not cancel.
MACULA_SHARED_CONST int kPairValues = 11;

// Statistics of a splat over views, which decide where to add splats and which to remove.
struct SplatStatistics {
    float views;       // number of views in which the splat showed
    float weight;      // sum of its blending weights over pixels and views
    float pull;        // sum over pixels of the absolute derivatives with respect to its mean, in pixels
    float mostWeight;  // the largest sum of its blending weights in one view
};

MACULA_SHARED_END
#endif
