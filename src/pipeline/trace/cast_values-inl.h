// Cast rays that gather values: castValues() of shaders/lib/cast.glsl by lanes of vectors.
//
// Included once for each instruction set by Highway, in macula::trace and its HWY_NAMESPACE; needs
// NativeHost.
#if defined(MACULA_CAST_VALUES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_CAST_VALUES_INL_H
#undef MACULA_CAST_VALUES_INL_H
#else
#define MACULA_CAST_VALUES_INL_H
#endif

#include <hwy/highway.h>

#include "pipeline/trace/cast_cells-inl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

class CastValues {
  public:
    HWY_INLINE CastValues(CastRays& rays, const CastTables& tables, const CopiedVoxels& voxels, float padding)
        : r_(rays),
          t_(tables),
          voxels_(voxels),
          padding_(padding),
          best_(hn::Load(f_, rays.best)),
          sum_(hn::Load(f_, rays.sum)),
          lengthMm_(hn::Load(f_, rays.lengthMm)) {}

    // Crosses cells until fewer than `enough` lanes do.
    template <int kLook>
    HWY_INLINE void cross(std::size_t enough) {
        LaneCells cells(r_);
        IntV state = hn::Load(i_, r_.state);
        do {
            state = cells.advance(state);
            const auto crossing = lanesIn(state, kCrossing);
            const Lanes3 low = cells.low();
            const LaneCorners corners = LaneCells::corners(voxels_, cells.placeOf(low));
            add<kLook>(floatMask(crossing), cells, corners, low);
            state = moved(state, crossing, kLeaving);
        } while (countIn(state, kLeaving) >= enough);
        hn::Store(state, i_, r_.state);
        cells.store();
        hn::Store(best_, f_, r_.best);
        hn::Store(sum_, f_, r_.sum);
        hn::Store(lengthMm_, f_, r_.lengthMm);
    }

  private:
    static constexpr Floats f_{};
    static constexpr Ints i_{};

    template <int kLook>
    HWY_INLINE void add(FloatMask of, const LaneCells& cells, const LaneCorners& corners, const Lanes3& low) {
        if (kLook == shared::kCastMean) return addToMean(of, cells, corners, low);
        constexpr bool kIsLeast = kLook == shared::kCastMinimum;
        LaneCorners c = corners;
        if (kIsLeast)
            for (FloatV& at : c.at) at = hn::Neg(at);
        FloatV most = c.at[0];
        for (int i = 1; i < 8; ++i) most = hn::Max(most, c.at[i]);
        // No value in a cell exceeds its corners.
        auto counts = hn::And(of, hn::Gt(most, best_));
        if (hn::AllFalse(f_, counts)) return;
        counts = hn::And(counts, isCounted<kLook>(corners));
        if (t_.matter.mask != nullptr) counts = hn::And(counts, isShown(counts, cells, low));
        if (hn::AllFalse(f_, counts)) return;
        best_ = hn::IfThenElse(counts, hn::Max(best_, largest(cells, c, low)), best_);
    }

    // The mean is exact, by Simpson's rule on cubics.
    HWY_INLINE void addToMean(FloatMask of, const LaneCells& cells, const LaneCorners& corners,
                              const Lanes3& low) {
        auto counts = hn::And(of, isCounted<shared::kCastMean>(corners));
        if (t_.matter.mask != nullptr) counts = hn::And(counts, isShown(counts, cells, low));
        const Lanes3 entry = cells.fractionAt(low, cells.from());
        const Lanes3 exit = cells.fractionAt(low, cells.to());
        const FloatV start = interpolated(corners, entry);
        const FloatV middle = interpolated(corners, between(entry, exit));
        const FloatV end = interpolated(corners, exit);
        const FloatV length = hn::IfThenElseZero(counts, hn::Sub(cells.to(), cells.from()));
        const FloatV all = hn::Add(hn::MulAdd(hn::Set(f_, 4.0f), middle, start), end);
        sum_ = hn::MulAdd(all, hn::Mul(length, hn::Set(f_, 1.0f / 6.0f)), sum_);
        lengthMm_ = hn::Add(lengthMm_, length);
        const FloatV here = hn::Max(hn::Max(start, end), middle);
        best_ = hn::IfThenElse(counts, hn::Max(best_, here), best_);
    }

    // The largest value that castValues() looks at in a cell.
    HWY_INLINE FloatV largest(const LaneCells& cells, const LaneCorners& c, const Lanes3& low) const {
        const Lanes3 entry = cells.fractionAt(low, cells.from());
        const Lanes3 exit = cells.fractionAt(low, cells.to());
        const Lanes3 middle = between(entry, exit);
        const FloatV ends = hn::Max(interpolated(c, entry), interpolated(c, exit));
        const FloatV quarters =
            hn::Max(interpolated(c, between(entry, middle)), interpolated(c, between(middle, exit)));
        return hn::Max(hn::Max(ends, interpolated(c, middle)), quarters);
    }

    HWY_INLINE Lanes3 between(const Lanes3& a, const Lanes3& b) const {
        const FloatV half = hn::Set(f_, 0.5f);
        return {hn::Mul(hn::Add(a.x, b.x), half), hn::Mul(hn::Add(a.y, b.y), half),
                hn::Mul(hn::Add(a.z, b.z), half)};
    }

    // isCounted() of cast.glsl.
    template <int kLook>
    HWY_INLINE FloatMask isCounted(const LaneCorners& c) const {
        const FloatV padding = hn::Set(f_, padding_);
        FloatV most = hn::Abs(hn::Sub(c.at[0], padding));
        FloatV least = most;
        for (int i = 1; i < 8; ++i) {
            const FloatV away = hn::Abs(hn::Sub(c.at[i], padding));
            most = hn::Max(most, away);
            least = hn::Min(least, away);
        }
        // Differences of entries are 0 or at least 1.
        return hn::Gt(kLook == shared::kCastMaximum ? most : least, hn::Set(f_, 0.5f));
    }

    // Whether the mask shows the middle of the ray's stretch; in idle lanes any.
    HWY_INLINE FloatMask isShown(FloatMask of, const LaneCells& cells, const Lanes3& low) const {
        const FloatV half = hn::Set(f_, 0.5f);
        const Lanes3 fraction = cells.fractionAt(low, hn::Mul(hn::Add(cells.from(), cells.to()), half));
        const Lanes3 at{hn::Add(hn::Add(low.x, fraction.x), half), hn::Add(hn::Add(low.y, fraction.y), half),
                        hn::Add(hn::Add(low.z, fraction.z), half)};
        return hn::Not(t_.matter.isMasked(of, at));
    }

    CastRays& r_;
    const CastTables& t_;
    CopiedVoxels voxels_;
    float padding_;
    FloatV best_, sum_, lengthMm_;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#endif
