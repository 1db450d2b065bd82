#include "pipeline/hybrid/views/sobol.h"

namespace macula::hybrid {

namespace {

// The finaliser of SplitMix64 (Steele et al. 2014): each output bit depends on all input bits.
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// Flips each bit or not, by a hash of all bits above it.
std::uint32_t scrambled(std::uint32_t bits, std::uint64_t seed) {
    std::uint32_t flips = 0;
    for (unsigned place = 0; place < 32; ++place) {
        // The bits above this one, with a leading 1 that marks how many they are.
        const std::uint64_t above = (std::uint64_t{1} << place) | (place == 0 ? 0u : bits >> (32u - place));
        flips |= static_cast<std::uint32_t>(mixed(seed ^ mixed(above)) & 1u) << (31u - place);
    }
    return bits ^ flips;
}

}  // namespace

glm::dvec2 scrambledSobol(std::uint32_t index, std::uint64_t seed) {
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    // Direction numbers: single bits in the first dimension; in the second, whose primitive polynomial is
    // x + 1, each is the previous one, xored with itself shifted by one.
    std::uint32_t directionX = 1u << 31;
    std::uint32_t directionY = 1u << 31;
    for (std::uint32_t rest = index; rest != 0; rest >>= 1) {
        if ((rest & 1u) != 0) {
            x ^= directionX;
            y ^= directionY;
        }
        directionX >>= 1;
        directionY ^= directionY >> 1;
    }
    constexpr double kUnit = 1.0 / 4294967296.0;
    return {kUnit * scrambled(x, mixed(2 * seed)), kUnit * scrambled(y, mixed(2 * seed + 1))};
}

}  // namespace macula::hybrid
