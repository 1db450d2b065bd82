// Low-discrepancy points of the unit square (scrambled Sobol nets) for a path's two-dimensional choices: the
// direction to a light, and the direction of scattering.
//
// In the first two dimensions of Sobol's sequence (1967), any 2^k successive points that begin at a multiple
// of 2^k form a (0, k, 2)-net: repeated halving divides the square into 2^k rectangles of equal shape, each
// with one point. Swapping the halves at random, then the halves of each half, and so on (Owen 1995) keeps
// this and makes each point uniform, so that every estimate stays unbiased; a hash implements it (Laine and
// Karras 2011, "Stratified sampling for stochastic transparency"; multipliers by Vegdahl). Shuffling the
// order of points likewise makes the points of different choices independent (Burley 2020, "Practical
// hash-based Owen scrambling").
//
// Needs lib/rng.glsl, and kNetSamples of shared/trace_params.h.

struct Net {
    uint index;  // of the point in the sequence
    uint seed;   // of the sequence
};

// A permutation of 2^32 numbers in which each bit affects only the bits above it: Owen's scrambling for
// numbers stored with reversed bits.
uint permutedUpwards(uint x, uint seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16u) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

// Sobol's second dimension, lowest bit first: multiplies by Pascal's triangle modulo 2, one power of two at a
// time.
uint pascalTriangle(uint x) {
    x ^= (x & 0xaaaaaaaau) >> 1u;
    x ^= (x & 0xccccccccu) >> 2u;
    x ^= (x & 0xf0f0f0f0u) >> 4u;
    x ^= (x & 0xff00ff00u) >> 8u;
    x ^= x >> 16u;
    return x;
}

// The point for the path's choice with this number. Coordinates are multiples of 2^-24 in [0, 1).
vec2 netPoint(Net net, uint choice) {
    uint seed = hashOf(choice, net.seed);
    uint index = bitfieldReverse(permutedUpwards(bitfieldReverse(net.index), seed));
    uint x = bitfieldReverse(permutedUpwards(index, hashOf(1u, seed)));
    uint y = bitfieldReverse(permutedUpwards(pascalTriangle(index), hashOf(2u, seed)));
    return vec2(float(x >> 8u), float(y >> 8u)) * float(1.0 / 16777216.0);
}

// Spreads the lowest 16 bits to every second bit, for a Morton index.
uint spread(uint x) {
    x &= 0xffffu;
    x = (x | (x << 8u)) & 0x00ff00ffu;
    x = (x | (x << 4u)) & 0x0f0f0f0fu;
    x = (x | (x << 2u)) & 0x33333333u;
    return (x | (x << 1u)) & 0x55555555u;
}

// kNetSamples samples of a pixel form a net, and so do those of four neighbours, of sixteen, and so on: where
// one pixel is too bright by chance, its neighbours tend to be too dark (Ahmed and Wonka 2020, "Screen-space
// blue-noise diffusion of Monte Carlo sampling error via hierarchical ordering of pixels").
Net netOfPixel(uint pixelX, uint pixelY, uint sampleIndex, uint seed) {
    uint place = spread(pixelX) | (spread(pixelY) << 1u);
    return Net(place * kNetSamples + sampleIndex % kNetSamples, hashOf(sampleIndex / kNetSamples, seed));
}
