// Splats whose numbers lie beside each other (shared/splat_layout.h), one in each lane of a vector. Compiled
// once for each instruction set.
#if defined(MACULA_SPLAT_NEIGHBOURS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_SPLAT_NEIGHBOURS_H
#undef MACULA_SPLAT_NEIGHBOURS_H
#else
#define MACULA_SPLAT_NEIGHBOURS_H
#endif

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/parallel.h"
#include "base/vector_in_glsl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::splat::HWY_NAMESPACE {

using namespace macula::HWY_NAMESPACE;

using Numbers = std::array<float, kLanes>;

// One number of each of a few neighbouring splats: fewer than a vector has lanes where there are no more. The
// lanes beyond have zeros.
struct Neighbours {
    std::size_t count;

    HWY_INLINE bool isWhole() const { return kLanes == 1 || count == kLanes; }

    HWY_INLINE Float load(const float* from) const {
        if (isWhole()) return Float::load(from);
        Numbers numbers{};
        std::copy_n(from, count, numbers.begin());
        return Float::load(numbers.data());
    }
    HWY_INLINE void store(Float value, float* to) const {
        if (isWhole()) return value.store(to);
        Numbers numbers;
        value.store(numbers.data());
        std::copy_n(numbers.begin(), count, to);
    }
    HWY_INLINE void store(Float value, Mask where, float* to) const {
        store(GlslInVectors::mix(load(to), value, where), to);
    }
};

// Calls body(first, neighbours) for all of `count` splats, on all cores.
template <class Body>
void forNeighbours(std::size_t count, const Body& body) {
    constexpr std::size_t kAtOnce = 1024;  // splats for a thread, a multiple of a vector's lanes
    parallelFor((count + kAtOnce - 1) / kAtOnce, [&](std::size_t n) {
        const std::size_t end = std::min(count, (n + 1) * kAtOnce);
        for (std::size_t first = n * kAtOnce; first < end; first += kLanes)
            body(first, Neighbours{std::min(kLanes, count - first)});
    });
}

}  // namespace macula::splat::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
