// Voxels by lanes of vectors, as they lie in the pool and the table of DeviceVolume: the fetches of
// shaders/trace/host.glsl, and what shaders/lib/medium.glsl interpolates of them. Coordinates as there, with
// integers at the faces of voxels.
//
// Included once for each instruction set by Highway, in macula::trace and its HWY_NAMESPACE.
#if defined(MACULA_LANE_VOXELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_LANE_VOXELS_INL_H
#undef MACULA_LANE_VOXELS_INL_H
#else
#define MACULA_LANE_VOXELS_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>

#include "pipeline/trace/host_tables.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Ints = hn::RebindToSigned<Floats>;
using Uints = hn::RebindToUnsigned<Floats>;
using FloatV = hn::Vec<Floats>;
using IntV = hn::Vec<Ints>;
using UintV = hn::Vec<Uints>;
using IntMask = hn::Mask<Ints>;
using FloatMask = hn::Mask<Floats>;

struct Lanes3 {
    FloatV x, y, z;
};

HWY_INLINE FloatV mixed(FloatV a, FloatV b, FloatV part) {
    return hn::MulAdd(part, hn::Sub(b, a), a);
}

// Of lanes, as bits.
HWY_INLINE std::uint32_t bitsOf(IntMask m) {
    alignas(8) std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(Ints(), m, bytes);
    return std::uint32_t(bytes[0]) | std::uint32_t(bytes[1]) << 8;
}

struct LaneVoxels {
    const std::int32_t* words;  // of blocks
    const std::int32_t* pool;   // two values in each
    glm::ivec3 grid;
    glm::ivec3 size;
    bool isCoarse;

    // The value of a voxel within the volume.
    HWY_INLINE FloatV at(IntV x, IntV y, IntV z) const {
        const IntV first = wordsOf(hn::ShiftRight<3>(x), hn::ShiftRight<3>(y), hn::ShiftRight<3>(z));
        const IntV seven = hn::Set(i_, 7);
        return valueIn(hn::GatherIndex(i_, words, hn::Add(first, hn::Set(i_, 3))), hn::And(x, seven),
                       hn::And(y, seven), hn::And(z, seven));
    }

    // The voxel centre below a coordinate, and where the coordinate lies between it and the next: in idle
    // lanes any.
    struct Between {
        IntV low, high;
        FloatV part;
    };
    HWY_INLINE Between between(FloatMask of, FloatV coordinate, int count) const {
        const FloatV last = hn::Set(f_, float(count - 1));
        const FloatV q =
            hn::Clamp(hn::IfThenElseZero(of, hn::Sub(coordinate, hn::Set(f_, 0.5f))), hn::Zero(f_), last);
        const IntV low = hn::ConvertTo(i_, q);
        return {low, hn::Min(hn::Add(low, hn::Set(i_, 1)), hn::Set(i_, count - 1)),
                hn::Sub(q, hn::ConvertTo(f_, low))};
    }

    // fetchCorners() of shaders/trace/host.glsl and trilinearEntry() of medium.glsl. Loads lane by lane, two
    // values at a time: processors gather no faster.
    HWY_INLINE FloatV trilinear(FloatMask of, Lanes3 p) const {
        const Between x = between(of, p.x, size.x);
        const Between y = between(of, p.y, size.y);
        const Between z = between(of, p.z, size.z);
        const IntV one = hn::Set(i_, 1);
        const IntV brickX = hn::ShiftRight<3>(hn::Add(x.low, one));
        const IntV brickY = hn::ShiftRight<3>(hn::Add(y.low, one));
        CornerPlaces places;
        hn::Store(wordsOf(brickX, brickY, hn::ShiftRight<3>(z.low)), i_, places.near);
        hn::Store(wordsOf(brickX, brickY, hn::ShiftRight<3>(z.high)), i_, places.far);
        const auto storeBoth = [&](const Between& at, std::int32_t* low, std::int32_t* high) HWY_ATTR {
            hn::Store(hn::And(at.low, hn::Set(i_, 7)), i_, low);
            hn::Store(hn::And(at.high, hn::Set(i_, 7)), i_, high);
        };
        storeBoth(x, places.x[0], places.x[1]);
        storeBoth(y, places.y[0], places.y[1]);
        storeBoth(z, places.z[0], places.z[1]);
        alignas(64) std::uint32_t rows[4][kLanes];
        if (!isCoarse) readRows(places, rows);
        std::uint32_t others =
            isCoarse ? (1u << kLanes) - 1 : bitsOf(hn::Eq(hn::And(x.low, hn::Set(i_, 7)), hn::Set(i_, 7)));
        for (; others != 0; others &= others - 1)
            readCorners(places, std::size_t(std::countr_zero(others)), rows);
        const auto row = [&](int n) HWY_ATTR {
            const UintV pair = hn::Load(u_, rows[n]);
            return mixed(hn::ConvertTo(f_, hn::BitCast(i_, hn::And(pair, hn::Set(u_, 0xffffu)))),
                         hn::ConvertTo(f_, hn::BitCast(i_, hn::ShiftRight<16>(pair))), x.part);
        };
        return mixed(mixed(row(0), row(1), y.part), mixed(row(2), row(3), y.part), z.part);
    }

  private:
    static constexpr Floats f_{};
    static constexpr Ints i_{};
    static constexpr Uints u_{};

    static constexpr std::size_t kLanes = hn::MaxLanes(Floats());

    // Where the corners around points lie, by lane, and low or high.
    struct CornerPlaces {
        alignas(64) std::int32_t near[kLanes];  // words of the brick at the low end of z
        alignas(64) std::int32_t far[kLanes];
        alignas(64) std::int32_t x[2][kLanes];  // within a block
        alignas(64) std::int32_t y[2][kLanes];
        alignas(64) std::int32_t z[2][kLanes];
    };

    // Two values along x, the low one in the low half: at the low and the high end of y, and the same at the
    // high end of z. As if no two lay in different blocks along x, and no block were coarse.
    HWY_INLINE void readRows(const CornerPlaces& places, std::uint32_t (*rows)[kLanes]) const {
        const std::int32_t* const blocks = words;
        const auto* const values = reinterpret_cast<const std::uint16_t*>(pool);
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const int x = std::min(places.x[0][lane], 6);
            const int y = places.y[0][lane];
            const int low = y << 3 | x;
            const int high = places.y[1][lane] << 3 | x;
            // A low corner may lie in the block before the brick's own, which is the last of the four.
            const int lowRow = y == 7 ? 1 : 3;
            const std::int32_t* const near = blocks + places.near[lane];
            const std::int32_t* const far = blocks + places.far[lane];
            const int nearZ = places.z[0][lane] << 6;
            const int farZ = places.z[1][lane] << 6;
            rows[0][lane] = pairIn(values, near[lowRow], nearZ | low);
            rows[1][lane] = pairIn(values, near[3], nearZ | high);
            rows[2][lane] = pairIn(values, far[lowRow], farZ | low);
            rows[3][lane] = pairIn(values, far[3], farZ | high);
        }
    }

    // The same for a lane of which that does not hold.
    HWY_INLINE void readCorners(const CornerPlaces& places, std::size_t lane,
                                std::uint32_t (*rows)[kLanes]) const {
        const PooledVoxels voxels{.pool = reinterpret_cast<const std::uint16_t*>(pool)};
        for (int row = 0; row < 4; ++row) {
            const std::int32_t* const blocks = words + (row < 2 ? places.near : places.far)[lane];
            const int y = places.y[row % 2][lane];
            const int z = places.z[row / 2][lane];
            const int first = row % 2 == 0 && y == 7 ? 0 : 2;
            const int lowX = places.x[0][lane];
            const auto valueIn = [&](int column, int x) {
                return voxels.valueIn(static_cast<std::uint32_t>(blocks[first + column]), {x, y, z});
            };
            rows[row][lane] = valueIn(lowX == 7 ? 0 : 1, lowX) | valueIn(1, places.x[1][lane]) << 16;
        }
    }

    // The values at a place in a whole block, and next to it along x.
    HWY_INLINE static std::uint32_t pairIn(const std::uint16_t* values, std::int32_t word, int inside) {
        const std::uint32_t payload = static_cast<std::uint32_t>(word) & 0x3fffffffu;
        const bool single = static_cast<std::uint32_t>(word) >> 30 == kSingle;
        const std::size_t place = (std::size_t(payload) << 3) + std::size_t(inside);
        std::uint32_t pair;
        std::memcpy(&pair, values + (single ? 0 : place), sizeof(pair));
        return single ? payload | payload << 16 : pair;
    }

    // A voxel's value by the word of its block: placeIn() and valueOf() of shaders/trace/host.glsl.
    HWY_INLINE FloatV valueIn(IntV word, IntV x, IntV y, IntV z) const {
        const IntV payload = hn::And(word, hn::Set(i_, 0x3fffffff));
        const IntV level = hn::BitCast(i_, hn::ShiftRight<30>(hn::BitCast(u_, word)));
        IntV inside;
        if (isCoarse) {
            const IntV edgeBits = hn::Sub(hn::Set(i_, 3), level);
            inside =
                hn::Or(hn::Shl(hn::Or(hn::Shl(hn::Shr(z, level), edgeBits), hn::Shr(y, level)), edgeBits),
                       hn::Shr(x, level));
        } else {
            inside = hn::Or(hn::Or(hn::ShiftLeft<6>(z), hn::ShiftLeft<3>(y)), x);
        }
        const auto single = hn::Eq(level, hn::Set(i_, int(kSingle)));
        const IntV place = hn::IfThenZeroElse(single, hn::Add(hn::ShiftLeft<3>(payload), inside));
        const UintV pair = hn::BitCast(u_, hn::GatherIndex(i_, pool, hn::ShiftRight<1>(place)));
        const auto isOdd = hn::Ne(hn::And(place, hn::Set(i_, 1)), hn::Zero(i_));
        const UintV value = hn::IfThenElse(hn::RebindMask(u_, isOdd), hn::ShiftRight<16>(pair),
                                           hn::And(pair, hn::Set(u_, 0xffffu)));
        return hn::ConvertTo(f_, hn::IfThenElse(single, payload, hn::BitCast(i_, value)));
    }

    // The index of the four words for a brick, in a layer of blocks.
    HWY_INLINE IntV wordsOf(IntV brickX, IntV brickY, IntV layer) const {
        const IntV row = hn::Add(hn::Mul(layer, hn::Set(i_, grid.y)), brickY);
        return hn::ShiftLeft<2>(hn::Add(hn::Mul(row, hn::Set(i_, grid.x)), brickX));
    }
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#endif
