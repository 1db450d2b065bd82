// Counter-based random numbers: a value depends only on (pixel, sample, seed, counter), so a picture is the
// same however its tiles and samples are split over dispatches, devices and frames.
//
// The mix is a keyed form of the two-multiplication 32-bit finalizers found by exhaustive search (Wellons
// 2018, "Prospecting for hash functions"); the two key words come from pcg4d (Jarzynski and Olano 2020).

struct Rng {
    uint key0;
    uint key1;
    uint counter;
};

Rng makeRng(uint pixelX, uint pixelY, uint sampleIndex, uint seed) {
    uint x = pixelX * 1664525u + 1013904223u;
    uint y = pixelY * 1664525u + 1013904223u;
    uint z = sampleIndex * 1664525u + 1013904223u;
    uint w = seed * 1664525u + 1013904223u;
    x += y * w;
    y += z * x;
    z += x * y;
    w += y * z;
    x ^= x >> 16u;
    y ^= y >> 16u;
    z ^= z >> 16u;
    w ^= w >> 16u;
    x += y * w;
    y += z * x;
    z += x * y;
    w += y * z;
    return Rng(x ^ z, y ^ w, 0u);
}

uint mixedBits(uint h, uint key) {
    h ^= h >> 16u;
    h *= 0x21f0aaadu;
    h += key;
    h ^= h >> 15u;
    h *= 0x735a2d97u;
    h ^= h >> 15u;
    return h;
}

// Hashes two words into one; neighbouring inputs give unrelated outputs.
uint hashOf(uint a, uint b) {
    return mixedBits(a * 0x9e3779b9u + b, 0u);
}

uint randomBits(INOUT(Rng) rng) {
    uint bits = mixedBits(rng.counter * 0x9e3779b9u + rng.key0, rng.key1);
    rng.counter += 1u;
    return bits;
}

// A random number in [0, 1), a multiple of 2^-24.
float random01(INOUT(Rng) rng) {
    return float(randomBits(rng) >> 8u) * float(1.0 / 16777216.0);
}

// The depth to the next event of a Poisson process of rate 1, by inversion of a random number in [0, 1). A
// series near 0: Vulkan allows log() an absolute error of 2^-21 there, one percent of the optical depth of a
// brick of faint fog.
float exponentialDepth(float u) {
    float near = u * (float(1.0) + u * (float(0.5) + u * float(1.0 / 3.0)));
    return u < float(1e-3) ? near : -log(float(1.0) - u);
}

// Three numbers in (0, 1) from one draw, with 11, 11 and 10 bits: enough to choose a neighbouring voxel.
vec3 random01Coarse3(INOUT(Rng) rng) {
    uint bits = randomBits(rng);
    return vec3((float(bits & 2047u) + float(0.5)) * float(1.0 / 2048.0),
                (float((bits >> 11u) & 2047u) + float(0.5)) * float(1.0 / 2048.0),
                (float(bits >> 22u) + float(0.5)) * float(1.0 / 1024.0));
}
