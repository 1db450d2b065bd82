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

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

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

    // fetchCorners() of shaders/trace/host.glsl and trilinearEntry() of medium.glsl.
    HWY_INLINE FloatV trilinear(FloatMask of, Lanes3 p) const {
        const IntV one = hn::Set(i_, 1);
        const IntV seven = hn::Set(i_, 7);
        const Between x = between(of, p.x, size.x);
        const Between y = between(of, p.y, size.y);
        const Between z = between(of, p.z, size.z);
        const IntV brickX = hn::ShiftRight<3>(hn::Add(x.low, one));
        const IntV brickY = hn::ShiftRight<3>(hn::Add(y.low, one));
        const IntV xLow = hn::And(x.low, seven);
        const IntV yLow = hn::And(y.low, seven);
        const IntV xHigh = hn::And(x.high, seven);
        const IntV yHigh = hn::And(y.high, seven);
        // A low corner may lie in the block before the brick's own.
        const IntV column = hn::IfThenZeroElse(hn::Eq(xLow, seven), one);
        const IntV row = hn::IfThenZeroElse(hn::Eq(yLow, seven), hn::Set(i_, 2));
        const auto layer = [&](IntV atZ) HWY_ATTR {
            const IntV first = wordsOf(brickX, brickY, hn::ShiftRight<3>(atZ));
            const IntV zIn = hn::And(atZ, seven);
            const IntV lowRow = hn::Add(first, row);
            const IntV highRow = hn::Add(first, hn::Set(i_, 2));
            const auto word = [&](IntV at) HWY_ATTR { return hn::GatherIndex(i_, words, at); };
            const FloatV a = valueIn(word(hn::Add(lowRow, column)), xLow, yLow, zIn);
            const FloatV b = valueIn(word(hn::Add(lowRow, one)), xHigh, yLow, zIn);
            const FloatV c = valueIn(word(hn::Add(highRow, column)), xLow, yHigh, zIn);
            const FloatV d = valueIn(word(hn::Add(highRow, one)), xHigh, yHigh, zIn);
            return mixed(mixed(a, b, x.part), mixed(c, d, x.part), y.part);
        };
        return mixed(layer(z.low), layer(z.high), z.part);
    }

  private:
    static constexpr Floats f_{};
    static constexpr Ints i_{};
    static constexpr Uints u_{};

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
