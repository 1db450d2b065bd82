// Cast rays through matter: castMatter() of shaders/lib/cast.glsl by lanes of vectors.
//
// Included once for each instruction set by Highway, in macula::trace and its HWY_NAMESPACE; needs NativeHost.
#if defined(MACULA_CAST_MATTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_CAST_MATTER_INL_H
#undef MACULA_CAST_MATTER_INL_H
#else
#define MACULA_CAST_MATTER_INL_H
#endif

#include <hwy/highway.h>
// After it.
#include <hwy/contrib/math/math-inl.h>

#include "pipeline/trace/cast_cells-inl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

// What castMatter() reads besides.
struct CastMatterTables {
    const float* flat;   // albedo and extinction, four numbers for each entry
    const float* steep;  // the same of steep matter; null: it has no curves of its own
    const std::int32_t* nextMatter;  // by entry: the first entry from it on with any extinction
    bool isShaded;
    float stepsPerEntry;
    float ambient, diffuse;

    bool hasGradients(const LaneMatter& matter) const {
        return isShaded || steep != nullptr || matter.gradientOpacity != nullptr;
    }
};

// Colour and extinction.
struct LaneOptics {
    FloatV r, g, b, extinction;
};

class CastMatter {
  public:
    HWY_INLINE CastMatter(CastRays& rays, const CastTables& tables, const CastMatterTables& matter,
                          const CopiedVoxels& voxels)
        : r_(rays), t_(tables), m_(matter), voxels_(voxels), hasGradients_(matter.hasGradients(tables.matter)) {}

    // Crosses cells without matter, until fewer than `enough` lanes do.
    HWY_INLINE void cross(std::size_t enough) {
        LaneCells cells(r_);
        IntV state = hn::Load(i_, r_.state);
        do {
            const auto leaving = lanesIn(state, kLeaving);
            const auto ended = cells.advance(floatMask(leaving));
            state = moved(moved(state, leaving, kCrossing), intMask(ended), kSeeking);
            const auto crossing = lanesIn(state, kCrossing);
            const Lanes3 low = cells.low();
            const IntV place = cells.placeOf(low);
            const LaneCorners corners = LaneCells::corners(voxels_, place);
            const auto meets = hn::And(floatMask(crossing), hasMatter(corners));
            state = moved(moved(state, crossing, kLeaving), intMask(meets), kStepping);
            if (!hn::AllFalse(f_, meets)) begin(meets, cells, corners, low, place);
        } while (countIn(state, kLeaving) >= enough);
        hn::Store(state, i_, r_.state);
        cells.store();
        finish(state);
    }

    // Takes steps until fewer than `enough` lanes do.
    HWY_INLINE void step(std::size_t enough) {
        const LaneCells cells(r_);
        const Lanes3 low = cells.low();
        const FloatV steps = hn::Load(f_, r_.steps);
        const FloatV phase = hn::Load(f_, r_.phase);
        const FloatV stepMm = hn::Load(f_, r_.stepMm);
        const FloatV lengthMm = hn::Sub(cells.to(), cells.from());
        const FloatV opaque = hn::Set(f_, NativeHost::kCastOpaque);
        FloatV step = hn::Load(f_, r_.step);
        FloatV transmittance = hn::Load(f_, r_.transmittance);
        Lanes3 colour = r_.colour.load();
        IntV state = hn::Load(i_, r_.state);
        do {
            const auto stepping = floatMask(lanesIn(state, kStepping));
            const FloatV part = hn::Div(hn::Add(step, phase), steps);
            const FloatV entry = hn::Max(valueAt(part), hn::Zero(f_));
            const LaneOptics optics =
                opticsAt(stepping, cells, low, hn::MulAdd(lengthMm, part, cells.from()), entry);
            const FloatV through = hn::Exp(f_, hn::Neg(hn::Mul(optics.extinction, stepMm)));
            const FloatV seen = hn::IfThenElseZero(
                stepping, hn::Mul(transmittance, hn::Sub(hn::Set(f_, 1.0f), through)));
            colour.x = hn::MulAdd(optics.r, seen, colour.x);
            colour.y = hn::MulAdd(optics.g, seen, colour.y);
            colour.z = hn::MulAdd(optics.b, seen, colour.z);
            transmittance =
                hn::IfThenElse(stepping, hn::Mul(transmittance, through), transmittance);
            step = hn::Add(step, hn::Set(f_, 1.0f));
            const auto isOpaque = hn::And(stepping, hn::Lt(transmittance, opaque));
            const auto isThrough = hn::And(stepping, hn::Ge(step, steps));
            state = moved(moved(state, intMask(isThrough), kLeaving), intMask(isOpaque), kDone);
        } while (countIn(state, kStepping) >= enough);
        hn::Store(state, i_, r_.state);
        hn::Store(step, f_, r_.step);
        hn::Store(transmittance, f_, r_.transmittance);
        r_.colour.store(colour);
    }

  private:
    static constexpr Floats f_{};
    static constexpr Ints i_{};
    static constexpr Uints u_{};

    // Lanes at the end of their piece continue from there.
    HWY_INLINE void finish(IntV state) const {
        const auto seeking = floatMask(lanesIn(state, kSeeking));
        const FloatV end = hn::Load(f_, r_.pieceEndMm);
        hn::BlendedStore(end, seeking, f_, r_.distanceMm);
    }

    // Where some value in a cell may have an extinction. Elsewhere its steps would change nothing.
    HWY_INLINE FloatMask hasMatter(const LaneCorners& corners) const {
        FloatV least = corners.at[0];
        FloatV most = corners.at[0];
        for (int i = 1; i < 8; ++i) {
            least = hn::Min(least, corners.at[i]);
            most = hn::Max(most, corners.at[i]);
        }
        // Rounding may carry a value an entry farther.
        const FloatV one = hn::Set(f_, 1.0f);
        const IntV from = hn::ConvertTo(i_, hn::Max(hn::Sub(least, one), hn::Zero(f_)));
        const IntV next = hn::GatherIndex(i_, m_.nextMatter, from);
        return hn::Le(hn::ConvertTo(f_, next), hn::Add(most, one));
    }

    // courseIn() of cell_walk.glsl, and the number of steps.
    HWY_INLINE void begin(FloatMask of, const LaneCells& cells, const LaneCorners& corners,
                          const Lanes3& low, IntV place) const {
        const FloatV half = hn::Set(f_, 0.5f);
        const Lanes3 entry = cells.fractionAt(low, cells.from());
        const Lanes3 exit = cells.fractionAt(low, cells.to());
        const Lanes3 between{hn::Mul(hn::Add(entry.x, exit.x), half), hn::Mul(hn::Add(entry.y, exit.y), half),
                             hn::Mul(hn::Add(entry.z, exit.z), half)};
        const FloatV start = interpolated(corners, entry);
        const FloatV middle = interpolated(corners, between);
        const FloatV end = interpolated(corners, exit);
        const FloatV toMiddle = hn::Sub(middle, start);
        const FloatV toEnd = hn::Sub(end, start);
        const FloatV across = hn::Mul(hn::Mul(hn::Sub(exit.x, entry.x), hn::Sub(exit.y, entry.y)),
                                      hn::Sub(exit.z, entry.z));
        const auto difference = [&](int corner) HWY_ATTR {
            return hn::Sub(corners.at[corner + 4], corners.at[corner]);
        };
        const FloatV third = hn::Mul(
            hn::Add(hn::Sub(hn::Sub(difference(0), difference(1)), difference(2)), difference(3)), across);
        const FloatV four = hn::Mul(hn::Set(f_, 4.0f), toMiddle);
        const FloatV first = hn::MulAdd(half, third, hn::Sub(four, toEnd));
        const FloatV second =
            hn::NegMulAdd(hn::Set(f_, 1.5f), third, hn::Sub(hn::Add(toEnd, toEnd), four));
        const FloatV change = hn::Add(hn::Abs(toMiddle), hn::Abs(hn::Sub(end, middle)));
        const FloatV wanted = hn::Mul(hn::Mul(change, hn::Set(f_, m_.stepsPerEntry)),
                                      hn::Load(f_, r_.transmittance));
        const FloatV steps = hn::Clamp(hn::Ceil(wanted), hn::Set(f_, hasGradients_ ? 2.0f : 1.0f),
                                       hn::Set(f_, float(NativeHost::kCastSteps)));
        hn::BlendedStore(start, of, f_, r_.course[0]);
        hn::BlendedStore(first, of, f_, r_.course[1]);
        hn::BlendedStore(second, of, f_, r_.course[2]);
        hn::BlendedStore(third, of, f_, r_.course[3]);
        hn::BlendedStore(steps, of, f_, r_.steps);
        hn::BlendedStore(hn::Zero(f_), of, f_, r_.step);
        hn::BlendedStore(hn::Div(hn::Sub(cells.to(), cells.from()), steps), of, f_, r_.stepMm);
        if (hasGradients_) beginGradients(of, corners, place);
    }

    // gradientOfCell() of cell_walk.glsl, and steepOfCell().
    HWY_INLINE void beginGradients(FloatMask of, const LaneCorners& c, IntV place) const {
        constexpr int kY = BrickCopies::kRow;
        constexpr int kZ = BrickCopies::kLayer;
        const FloatV half = hn::Set(f_, 0.5f);
        const auto keep = [&](int axis, int corner, FloatV high, FloatV low) HWY_ATTR {
            hn::BlendedStore(hn::Mul(hn::Sub(high, low), half), of, f_, r_.gradients[axis][corner]);
        };
        for (int k = 0; k < 2; ++k) {
            for (int j = 0; j < 2; ++j) {
                const int row = 2 * j + 4 * k;
                const FloatV before = voxels_.pair(place, j * kY + k * kZ - 1).low;
                const FloatV after = voxels_.pair(place, j * kY + k * kZ + 1).high;
                keep(0, row, c.at[row + 1], before);
                keep(0, row + 1, after, c.at[row]);
            }
            const LanePair beforeY = voxels_.pair(place, k * kZ - kY);
            const LanePair afterY = voxels_.pair(place, k * kZ + 2 * kY);
            keep(1, 4 * k, c.at[4 * k + 2], beforeY.low);
            keep(1, 4 * k + 1, c.at[4 * k + 3], beforeY.high);
            keep(1, 4 * k + 2, afterY.low, c.at[4 * k]);
            keep(1, 4 * k + 3, afterY.high, c.at[4 * k + 1]);
            const LanePair beforeZ = voxels_.pair(place, k * kY - kZ);
            const LanePair afterZ = voxels_.pair(place, k * kY + 2 * kZ);
            keep(2, 2 * k, c.at[2 * k + 4], beforeZ.low);
            keep(2, 2 * k + 1, c.at[2 * k + 5], beforeZ.high);
            keep(2, 2 * k + 4, afterZ.low, c.at[2 * k]);
            keep(2, 2 * k + 5, afterZ.high, c.at[2 * k + 1]);
        }
        if (m_.steep == nullptr) return;
        for (int corner = 0; corner < 8; ++corner) {
            const Lanes3 perVoxel{hn::Load(f_, r_.gradients[0][corner]), hn::Load(f_, r_.gradients[1][corner]),
                                  hn::Load(f_, r_.gradients[2][corner])};
            const FloatV length2 = squareOf(t_.matter.worldGradient(perVoxel));
            hn::BlendedStore(t_.matter.steepPartOf(length2), of, f_, r_.steepParts[corner]);
        }
    }

    HWY_INLINE FloatV valueAt(FloatV part) const {
        const auto slope = [&](int i) HWY_ATTR { return hn::Load(f_, r_.course[i]); };
        return hn::MulAdd(part, hn::MulAdd(part, hn::MulAdd(part, slope(3), slope(2)), slope(1)), slope(0));
    }

    HWY_INLINE FloatV interpolatedIn(const float (&corners)[8][kRays], const Lanes3& fraction) const {
        LaneCorners c;
        for (int i = 0; i < 8; ++i) c.at[i] = hn::Load(f_, corners[i]);
        return interpolated(c, fraction);
    }

    // One of the four numbers of an entry.
    HWY_INLINE FloatV numberOf(const float* table, IntV low, FloatV part, int number) const {
        const IntV at = hn::ShiftLeft<2>(low);
        return mixed(hn::GatherIndex(f_, table + number, at), hn::GatherIndex(f_, table + number + 4, at),
                     part);
    }

    // The light and the extinction of matter at a step; in lanes without extinction any light.
    HWY_INLINE LaneOptics opticsAt(FloatMask of, const LaneCells& cells, const Lanes3& low, FloatV atMm,
                                   FloatV anyEntry) const {
        const FloatV zero = hn::Zero(f_);
        const FloatV entry = hn::Min(hn::IfThenElseZero(of, anyEntry), hn::Set(f_, float(t_.entryCount - 2)));
        const IntV index = hn::ConvertTo(i_, entry);
        const FloatV part = hn::Sub(entry, hn::ConvertTo(f_, index));
        LaneOptics optics{zero, zero, zero, numberOf(m_.flat, index, part, 3)};
        FloatV steep = optics.extinction;
        if (m_.steep != nullptr) steep = numberOf(m_.steep, index, part, 3);
        const auto has =
            hn::And(of, hn::Or(hn::Ne(optics.extinction, zero), hn::Ne(steep, zero)));
        if (hn::AllFalse(f_, has)) return {zero, zero, zero, zero};
        optics.r = numberOf(m_.flat, index, part, 0);
        optics.g = numberOf(m_.flat, index, part, 1);
        optics.b = numberOf(m_.flat, index, part, 2);
        if (!hasGradients_ && t_.matter.mask == nullptr) return optics;
        const Lanes3 fraction = cells.fractionAt(low, atMm);
        if (hasGradients_) withGradient(optics, fraction, index, part, steep);
        if (t_.matter.mask != nullptr) {
            const FloatV half = hn::Set(f_, 0.5f);
            const Lanes3 at{hn::Add(hn::Add(low.x, fraction.x), half), hn::Add(hn::Add(low.y, fraction.y), half),
                            hn::Add(hn::Add(low.z, fraction.z), half)};
            optics.extinction = hn::IfThenZeroElse(t_.matter.isMasked(has, at), optics.extinction);
        }
        return optics;
    }

    // Applies gradient opacity, steep matter with this extinction, and the headlight.
    HWY_INLINE void withGradient(LaneOptics& optics, const Lanes3& fraction, IntV index, FloatV part,
                                 FloatV steep) const {
        const LaneMatter& matter = t_.matter;
        Lanes3 gradient{};
        FloatV length2 = hn::Zero(f_);
        if (m_.isShaded || matter.gradientOpacity != nullptr) {
            gradient = matter.worldGradient({interpolatedIn(r_.gradients[0], fraction),
                                             interpolatedIn(r_.gradients[1], fraction),
                                             interpolatedIn(r_.gradients[2], fraction)});
            length2 = squareOf(gradient);
        }
        if (matter.gradientOpacity != nullptr) {
            const FloatV opacity = matter.gradientOpacityOf(length2);
            optics.extinction = matter.thinned(optics.extinction, opacity);
            if (m_.steep != nullptr) steep = matter.thinned(steep, opacity);
        }
        if (m_.steep != nullptr) {
            // mixedMatter() of cast.glsl.
            const FloatV isSteep = interpolatedIn(r_.steepParts, fraction);
            optics.extinction = mixed(optics.extinction, steep, isSteep);
            const FloatV share =
                hn::Div(hn::Mul(steep, isSteep), hn::Max(optics.extinction, hn::Set(f_, 1e-20f)));
            optics.r = mixed(optics.r, numberOf(m_.steep, index, part, 0), share);
            optics.g = mixed(optics.g, numberOf(m_.steep, index, part, 1), share);
            optics.b = mixed(optics.b, numberOf(m_.steep, index, part, 2), share);
        }
        if (m_.isShaded) {
            const FloatV shade = headlight(gradient, length2);
            optics.r = hn::Mul(optics.r, shade);
            optics.g = hn::Mul(optics.g, shade);
            optics.b = hn::Mul(optics.b, shade);
        }
    }

    // headlight() of cast.glsl.
    HWY_INLINE FloatV headlight(const Lanes3& gradient, FloatV length2) const {
        const Lanes3 direction = r_.worldDirection.load();
        const FloatV along = hn::MulAdd(
            gradient.z, direction.z,
            hn::MulAdd(gradient.y, direction.y, hn::Mul(gradient.x, direction.x)));
        const auto isSurface = hn::Gt(length2, hn::Zero(f_));
        const FloatV one = hn::Set(f_, 1.0f);
        const FloatV length = hn::Sqrt(hn::IfThenElse(isSurface, length2, one));
        const FloatV cosine = hn::IfThenElse(isSurface, hn::Div(hn::Abs(along), length), one);
        return hn::MulAdd(hn::Set(f_, m_.diffuse), cosine, hn::Set(f_, m_.ambient));
    }

    CastRays& r_;
    const CastTables& t_;
    const CastMatterTables& m_;
    CopiedVoxels voxels_;
    bool hasGradients_;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#endif
