// Matter by lanes of vectors, where it depends on the volume's value, on gradients and on the mask: the
// extinctions of shaders/lib/medium.glsl, gradient.glsl and mask.glsl.
//
// Included once for each instruction set by Highway, in macula::trace and its HWY_NAMESPACE.
#if defined(MACULA_LANE_MATTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_LANE_MATTER_INL_H
#undef MACULA_LANE_MATTER_INL_H
#else
#define MACULA_LANE_MATTER_INL_H
#endif

#include <hwy/highway.h>
// After it.
#include <hwy/contrib/math/math-inl.h>

#include "pipeline/trace/host_tables.h"
#include "pipeline/trace/lane_voxels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE FloatV squareOf(const Lanes3& v) {
    return hn::MulAdd(v.z, v.z, hn::MulAdd(v.y, v.y, hn::Mul(v.x, v.x)));
}

struct LaneMatter {
    LaneVoxels voxels;
    const float* extinctionPerMm;
    const float* steep;            // four numbers for each entry, the last its extinction; null: none differs
    const float* gradientOpacity;  // null: there is none
    const std::int32_t* mask;      // null: there is none
    bool isTrilinear;
    glm::vec3 voxelFromWorldX, voxelFromWorldY, voxelFromWorldZ;
    float steepGradient;
    float gradientScale;
    int gradientLast;
    float unitDepthMm;

    LaneMatter(const HostTables<PooledVoxels>& tables, const NativeHost::Params& params, bool isCoarse,
               bool isTrilinear_)
        : voxels{.words = reinterpret_cast<const std::int32_t*>(tables.voxels.words),
                 .pool = reinterpret_cast<const std::int32_t*>(tables.voxels.pool),
                 .grid = params.gridSize,
                 .size = params.volumeSize,
                 .isCoarse = isCoarse},
          extinctionPerMm(tables.extinctionPerMm),
          steep(tables.hasSteepDensity ? &tables.steep.data()->x : nullptr),
          gradientOpacity(tables.gradientOpacity.data()),
          mask(reinterpret_cast<const std::int32_t*>(tables.mask.data())),
          isTrilinear(isTrilinear_),
          voxelFromWorldX(params.voxelFromWorldX),
          voxelFromWorldY(params.voxelFromWorldY),
          voxelFromWorldZ(params.voxelFromWorldZ),
          steepGradient(params.steepGradient),
          gradientScale(params.gradientScale),
          gradientLast(params.gradientLast),
          unitDepthMm(params.unitDepthMm) {}

    HWY_INLINE FloatV extinctionOfEntry(FloatV entry) const { return ofEntry<1>(extinctionPerMm, entry); }
    HWY_INLINE FloatV steepExtinctionOfEntry(FloatV entry) const { return ofEntry<4>(steep + 3, entry); }

    // The steep part of matter, 0 to 1, at a voxel within the volume.
    HWY_INLINE FloatV steepPart(IntV x, IntV y, IntV z) const {
        const IntV one = hn::Set(i_, 1);
        const auto around = [&](IntV at, int count) HWY_ATTR {
            return Around{hn::Max(hn::Sub(at, one), hn::Zero(i_)),
                          hn::Min(hn::Add(at, one), hn::Set(i_, count - 1))};
        };
        const Around inX = around(x, voxels.size.x);
        const Around inY = around(y, voxels.size.y);
        const Around inZ = around(z, voxels.size.z);
        return steepPartOf(squaredGradient({hn::Sub(voxels.at(inX.high, y, z), voxels.at(inX.low, y, z)),
                                            hn::Sub(voxels.at(x, inY.high, z), voxels.at(x, inY.low, z)),
                                            hn::Sub(voxels.at(x, y, inZ.high), voxels.at(x, y, inZ.low))}));
    }

    // The same for the squared length of a gradient.
    HWY_INLINE FloatV steepPartOf(FloatV length2) const {
        const FloatV half = hn::Set(f_, steepGradient * steepGradient);
        return hn::Div(length2, hn::Max(hn::Add(length2, half), hn::Set(f_, 1e-30f)));
    }

    // The gradient opacity at points, 0 to 1; in idle lanes any.
    HWY_INLINE FloatV opacityByGradient(FloatMask of, Lanes3 at) const {
        const FloatV one = hn::Set(f_, 1.0f);
        const auto value = [&](Lanes3 p) HWY_ATTR { return voxels.trilinear(of, p); };
        return gradientOpacityOf(squaredGradient(
            {hn::Sub(value({hn::Add(at.x, one), at.y, at.z}), value({hn::Sub(at.x, one), at.y, at.z})),
             hn::Sub(value({at.x, hn::Add(at.y, one), at.z}), value({at.x, hn::Sub(at.y, one), at.z})),
             hn::Sub(value({at.x, at.y, hn::Add(at.z, one)}), value({at.x, at.y, hn::Sub(at.z, one)}))}));
    }

    // The same for the squared length of a gradient.
    HWY_INLINE FloatV gradientOpacityOf(FloatV length2) const {
        const FloatV place = hn::Min(hn::Mul(hn::Sqrt(length2), hn::Set(f_, gradientScale)),
                                     hn::Set(f_, static_cast<float>(gradientLast)));
        const IntV low = hn::Min(hn::ConvertTo(i_, place), hn::Set(i_, gradientLast - 1));
        return mixed(hn::GatherIndex(f_, gradientOpacity, low),
                     hn::GatherIndex(f_, gradientOpacity, hn::Add(low, hn::Set(i_, 1))),
                     hn::Sub(place, hn::ConvertTo(f_, low)));
    }

    // thinnedByGradient() of gradient.glsl.
    HWY_INLINE FloatV thinned(FloatV extinction, FloatV byGradient) const {
        const FloatV one = hn::Set(f_, 1.0f);
        const FloatV through = hn::Exp(f_, hn::Mul(extinction, hn::Set(f_, -unitDepthMm)));
        const FloatV left = hn::NegMulAdd(byGradient, hn::Sub(one, through), one);
        // No denser than without it, where the logarithm of 0 is only a large number.
        return hn::Min(hn::Mul(hn::Log(f_, left), hn::Set(f_, -1.0f / unitDepthMm)), extinction);
    }

    // worldGradient() of gradient.glsl.
    HWY_INLINE Lanes3 worldGradient(const Lanes3& perVoxel) const {
        const auto isGradient = hn::Gt(squareOf(perVoxel), hn::Set(f_, 0.000625f));
        const auto along = [&](const glm::vec3& axis) HWY_ATTR {
            const FloatV dot = hn::MulAdd(
                hn::Set(f_, axis.z), perVoxel.z,
                hn::MulAdd(hn::Set(f_, axis.y), perVoxel.y, hn::Mul(hn::Set(f_, axis.x), perVoxel.x)));
            return hn::IfThenElseZero(isGradient, dot);
        };
        return {along(voxelFromWorldX), along(voxelFromWorldY), along(voxelFromWorldZ)};
    }

    // Where the mask hides points; in idle lanes any.
    HWY_INLINE FloatMask isMasked(FloatMask of, Lanes3 p) const {
        const auto x = voxels.between(of, p.x, voxels.size.x);
        const auto y = voxels.between(of, p.y, voxels.size.y);
        const auto z = voxels.between(of, p.z, voxels.size.z);
        const auto layer = [&](IntV atZ) HWY_ATTR {
            const auto row = [&](IntV atY) HWY_ATTR {
                return mixed(maskAt(x.low, atY, atZ), maskAt(x.high, atY, atZ), x.part);
            };
            return mixed(row(y.low), row(y.high), y.part);
        };
        return hn::Lt(mixed(layer(z.low), layer(z.high), z.part), hn::Set(f_, 0.5f));
    }

  private:
    static constexpr Floats f_{};
    static constexpr Ints i_{};
    static constexpr Uints u_{};

    struct Around {
        IntV low, high;
    };

    template <int kStep>
    HWY_INLINE FloatV ofEntry(const float* table, FloatV entry) const {
        const IntV low = hn::ConvertTo(i_, entry);
        const IntV index = kStep == 4 ? hn::ShiftLeft<2>(low) : low;
        const FloatV from = hn::GatherIndex(f_, table, index);
        if (!isTrilinear) return from;
        const FloatV to = hn::GatherIndex(f_, table, hn::Add(index, hn::Set(i_, kStep)));
        return mixed(from, to, hn::Sub(entry, hn::ConvertTo(f_, low)));
    }

    // The square of worldGradient() for differences over two voxels along each axis.
    HWY_INLINE FloatV squaredGradient(Lanes3 differences) const {
        const FloatV half = hn::Set(f_, 0.5f);
        return squareOf(worldGradient(
            {hn::Mul(differences.x, half), hn::Mul(differences.y, half), hn::Mul(differences.z, half)}));
    }

    HWY_INLINE FloatV maskAt(IntV x, IntV y, IntV z) const {
        const IntV row = hn::Add(hn::Mul(z, hn::Set(i_, voxels.size.y)), y);
        const UintV bit = hn::BitCast(u_, hn::Add(hn::Mul(row, hn::Set(i_, voxels.size.x)), x));
        const IntV word = hn::GatherIndex(i_, mask, hn::BitCast(i_, hn::ShiftRight<5>(bit)));
        const UintV bits = hn::Shr(hn::BitCast(u_, word), hn::And(bit, hn::Set(u_, 31u)));
        return hn::ConvertTo(f_, hn::BitCast(i_, hn::And(bits, hn::Set(u_, 1u))));
    }
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#endif
