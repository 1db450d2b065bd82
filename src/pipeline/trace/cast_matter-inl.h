// Cast rays through matter: castMatter() of shaders/lib/cast.glsl by lanes of vectors.
//
// Included once for each instruction set by Highway, in macula::trace and its HWY_NAMESPACE; needs
// NativeHost.
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
    const float* flat;               // albedo and extinction, four numbers for each entry
    const float* steep;              // the same of steep matter; null: it has no curves of its own
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
        : r_(rays),
          t_(tables),
          m_(matter),
          voxels_(voxels),
          hasGradients_(matter.hasGradients(tables.matter)),
          colour_(rays.colour.load()),
          transmittance_(hn::Load(f_, rays.transmittance)) {}

    // Crosses cells, until fewer than `enough` lanes do.
    HWY_INLINE void cross(std::size_t enough) {
        LaneCells cells(r_);
        IntV state = hn::Load(i_, r_.state);
        do {
            state = cells.advance(state);
            const auto crossing = lanesIn(state, kCrossing);
            const Lanes3 low = cells.low();
            const IntV place = cells.placeOf(low);
            const LaneCorners corners = LaneCells::corners(voxels_, place);
            const auto meets = hn::And(floatMask(crossing), hasMatter(corners));
            state = moved(moved(state, crossing, kLeaving), intMask(meets), kStepping);
            // Lanes wait for others before they take steps.
            const std::size_t waiting = countIn(state, kStepping);
            if (4 * waiting >= 3 * enough || countIn(state, kLeaving) == 0) {
                if (waiting > 0) state = afterSteps(state, cells, corners, low, place);
            }
        } while (countIn(state, kLeaving) + countIn(state, kStepping) >= enough);
        hn::Store(state, i_, r_.state);
        cells.store();
        hn::Store(transmittance_, f_, r_.transmittance);
        r_.colour.store(colour_);
    }

  private:
    static constexpr Floats f_{};
    static constexpr Ints i_{};

    // The value along the ray through a cell, and its steps.
    struct Course {
        FloatV start, first, second, third;
        FloatV steps;
    };
    // Central differences at the corners of a cell, and the steep parts there.
    struct Gradients {
        LaneCorners x, y, z;
        LaneCorners steep;
    };

    // Takes the steps of lanes through their cells. A lane that needs many more than others keeps some for
    // the next time.
    HWY_INLINE IntV afterSteps(IntV state, const LaneCells& cells, const LaneCorners& corners,
                               const Lanes3& low, IntV place) {
        const auto of = floatMask(lanesIn(state, kStepping));
        const Course course = courseIn(cells, corners, low);
        FloatV step = hn::Load(f_, r_.step);
        const auto isNew = hn::Eq(step, hn::Zero(f_));
        const FloatV steps = hn::IfThenElse(isNew, course.steps, hn::Load(f_, r_.steps));
        const FloatV lengthMm = hn::Sub(cells.to(), cells.from());
        const FloatV stepMm = hn::Div(lengthMm, steps);
        const FloatV perStep = hn::Div(hn::Set(f_, 1.0f), steps);
        const FloatV phase = hn::Load(f_, r_.phase);
        Gradients gradients;
        if (hasGradients_) gradients = gradientsOf(corners, place);
        const FloatV one = hn::Set(f_, 1.0f);
        auto stepping = of;
        do {
            const FloatV part = hn::Mul(hn::Add(step, phase), perStep);
            const FloatV entry = hn::Max(valueOf(course, part), hn::Zero(f_));
            const FloatV atMm = hn::MulAdd(lengthMm, part, cells.from());
            const LaneOptics optics = opticsAt(stepping, gradients, cells, low, atMm, entry);
            const FloatV through = hn::Exp(f_, hn::Neg(hn::Mul(optics.extinction, stepMm)));
            const FloatV seen = hn::IfThenElseZero(stepping, hn::Mul(transmittance_, hn::Sub(one, through)));
            colour_.x = hn::MulAdd(optics.r, seen, colour_.x);
            colour_.y = hn::MulAdd(optics.g, seen, colour_.y);
            colour_.z = hn::MulAdd(optics.b, seen, colour_.z);
            transmittance_ = hn::IfThenElse(stepping, hn::Mul(transmittance_, through), transmittance_);
            step = hn::IfThenElse(stepping, hn::Add(step, one), step);
            stepping = hn::And(hn::And(stepping, hn::Lt(step, steps)),
                               hn::Ge(transmittance_, hn::Set(f_, NativeHost::kCastOpaque)));
        } while (hn::CountTrue(f_, stepping) > hn::Lanes(f_) / 4);
        hn::BlendedStore(hn::IfThenElseZero(stepping, step), of, f_, r_.step);
        hn::BlendedStore(steps, of, f_, r_.steps);
        const auto isOpaque = hn::And(of, hn::Lt(transmittance_, hn::Set(f_, NativeHost::kCastOpaque)));
        state = moved(state, intMask(hn::AndNot(stepping, of)), kLeaving);
        return moved(state, intMask(isOpaque), kDone);
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
    HWY_INLINE Course courseIn(const LaneCells& cells, const LaneCorners& corners, const Lanes3& low) const {
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
        const FloatV across =
            hn::Mul(hn::Mul(hn::Sub(exit.x, entry.x), hn::Sub(exit.y, entry.y)), hn::Sub(exit.z, entry.z));
        const auto difference = [&](int corner)
                                    HWY_ATTR { return hn::Sub(corners.at[corner + 4], corners.at[corner]); };
        const FloatV third = hn::Mul(
            hn::Add(hn::Sub(hn::Sub(difference(0), difference(1)), difference(2)), difference(3)), across);
        const FloatV four = hn::Mul(hn::Set(f_, 4.0f), toMiddle);
        const FloatV change = hn::Add(hn::Abs(toMiddle), hn::Abs(hn::Sub(end, middle)));
        const FloatV wanted = hn::Mul(hn::Mul(change, hn::Set(f_, m_.stepsPerEntry)), transmittance_);
        return {start, hn::MulAdd(half, third, hn::Sub(four, toEnd)),
                hn::NegMulAdd(hn::Set(f_, 1.5f), third, hn::Sub(hn::Add(toEnd, toEnd), four)), third,
                hn::Clamp(hn::Ceil(wanted), hn::Set(f_, hasGradients_ ? 2.0f : 1.0f),
                          hn::Set(f_, float(NativeHost::kCastSteps)))};
    }

    // gradientOfCell() of cell_walk.glsl, and steepOfCell().
    HWY_INLINE Gradients gradientsOf(const LaneCorners& c, IntV place) const {
        constexpr int kY = BrickCopies::kRow;
        constexpr int kZ = BrickCopies::kLayer;
        const FloatV half = hn::Set(f_, 0.5f);
        const auto slope = [&](FloatV high, FloatV low)
                               HWY_ATTR { return hn::Mul(hn::Sub(high, low), half); };
        Gradients g;
        for (int k = 0; k < 2; ++k) {
            for (int j = 0; j < 2; ++j) {
                const int row = 2 * j + 4 * k;
                g.x.at[row] = slope(c.at[row + 1], voxels_.low(place, j * kY + k * kZ - 1));
                g.x.at[row + 1] = slope(voxels_.low(place, j * kY + k * kZ + 2), c.at[row]);
            }
            const LanePair beforeY = voxels_.pair(place, k * kZ - kY);
            const LanePair afterY = voxels_.pair(place, k * kZ + 2 * kY);
            g.y.at[4 * k] = slope(c.at[4 * k + 2], beforeY.low);
            g.y.at[4 * k + 1] = slope(c.at[4 * k + 3], beforeY.high);
            g.y.at[4 * k + 2] = slope(afterY.low, c.at[4 * k]);
            g.y.at[4 * k + 3] = slope(afterY.high, c.at[4 * k + 1]);
            const LanePair beforeZ = voxels_.pair(place, k * kY - kZ);
            const LanePair afterZ = voxels_.pair(place, k * kY + 2 * kZ);
            g.z.at[2 * k] = slope(c.at[2 * k + 4], beforeZ.low);
            g.z.at[2 * k + 1] = slope(c.at[2 * k + 5], beforeZ.high);
            g.z.at[2 * k + 4] = slope(afterZ.low, c.at[2 * k]);
            g.z.at[2 * k + 5] = slope(afterZ.high, c.at[2 * k + 1]);
        }
        if (m_.steep == nullptr) return g;
        for (int corner = 0; corner < 8; ++corner) {
            const Lanes3 perVoxel{g.x.at[corner], g.y.at[corner], g.z.at[corner]};
            g.steep.at[corner] = t_.matter.steepPartOf(squareOf(t_.matter.worldGradient(perVoxel)));
        }
        return g;
    }

    static HWY_INLINE FloatV valueOf(const Course& c, FloatV part) {
        return hn::MulAdd(part, hn::MulAdd(part, hn::MulAdd(part, c.third, c.second), c.first), c.start);
    }

    // Albedo and extinction between an entry and the next, as matterOfEntry() of cast.glsl.
    HWY_INLINE LaneOptics opticsOf(const float* table, IntV low, FloatV part) const {
        const LaneOptics a = numbersOf(table, low);
        const LaneOptics b = numbersOf(table + 4, low);
        return {mixed(a.r, b.r, part), mixed(a.g, b.g, part), mixed(a.b, b.b, part),
                mixed(a.extinction, b.extinction, part)};
    }

    // The four numbers of entries: a transposition of what lies together takes less than four gathers.
    HWY_INLINE LaneOptics numbersOf(const float* table, IntV low) const {
#if HWY_TARGET == HWY_SCALAR
        const float* const at = table + 4 * std::ptrdiff_t(hn::GetLane(low));
        return {hn::Set(f_, at[0]), hn::Set(f_, at[1]), hn::Set(f_, at[2]), hn::Set(f_, at[3])};
#else
        alignas(64) std::int32_t index[kRays];
        hn::Store(hn::ShiftLeft<2>(low), i_, index);
        // In each block of four lanes, the entry of its first, second, third and fourth lane.
        const FloatV first = blocksAt(f_, table, index);
        const FloatV second = blocksAt(f_, table, index + 1);
        const FloatV third = blocksAt(f_, table, index + 2);
        const FloatV fourth = blocksAt(f_, table, index + 3);
        const FloatV a = hn::InterleaveLower(f_, first, third);
        const FloatV b = hn::InterleaveLower(f_, second, fourth);
        const FloatV c = hn::InterleaveUpper(f_, first, third);
        const FloatV d = hn::InterleaveUpper(f_, second, fourth);
        return {hn::InterleaveLower(f_, a, b), hn::InterleaveUpper(f_, a, b), hn::InterleaveLower(f_, c, d),
                hn::InterleaveUpper(f_, c, d)};
#endif
    }

#if HWY_TARGET != HWY_SCALAR
    // Four numbers each from every fourth of these places.
    template <class D>
    static HWY_INLINE hn::Vec<D> blocksAt(D d, const float* table, const std::int32_t* index) {
        if constexpr (hn::MaxLanes(D()) == 4) {
            return hn::LoadU(d, table + *index);
        } else {
            const hn::Half<D> half;
            return hn::Combine(d, blocksAt(half, table, index + hn::MaxLanes(D()) / 2),
                               blocksAt(half, table, index));
        }
    }
#endif

    // The light and the extinction of matter at a step.
    HWY_INLINE LaneOptics opticsAt(FloatMask of, const Gradients& gradients, const LaneCells& cells,
                                   const Lanes3& low, FloatV atMm, FloatV anyEntry) const {
        const FloatV entry = hn::Min(hn::IfThenElseZero(of, anyEntry), hn::Set(f_, float(t_.entryCount - 2)));
        const IntV index = hn::ConvertTo(i_, entry);
        const FloatV part = hn::Sub(entry, hn::ConvertTo(f_, index));
        LaneOptics optics = opticsOf(m_.flat, index, part);
        if (!hasGradients_ && t_.matter.mask == nullptr) return optics;
        const Lanes3 fraction = cells.fractionAt(low, atMm);
        if (hasGradients_) {
            LaneOptics steep{};
            if (m_.steep != nullptr) steep = opticsOf(m_.steep, index, part);
            withGradient(optics, steep, gradients, fraction);
        }
        if (t_.matter.mask != nullptr) {
            const FloatV half = hn::Set(f_, 0.5f);
            const Lanes3 at{hn::Add(hn::Add(low.x, fraction.x), half),
                            hn::Add(hn::Add(low.y, fraction.y), half),
                            hn::Add(hn::Add(low.z, fraction.z), half)};
            optics.extinction = hn::IfThenZeroElse(t_.matter.isMasked(of, at), optics.extinction);
        }
        return optics;
    }

    // Applies gradient opacity, steep matter and the headlight.
    HWY_INLINE void withGradient(LaneOptics& optics, LaneOptics& steep, const Gradients& gradients,
                                 const Lanes3& fraction) const {
        const LaneMatter& matter = t_.matter;
        Lanes3 gradient{};
        FloatV length2 = hn::Zero(f_);
        if (m_.isShaded || matter.gradientOpacity != nullptr) {
            gradient = matter.worldGradient({interpolated(gradients.x, fraction),
                                             interpolated(gradients.y, fraction),
                                             interpolated(gradients.z, fraction)});
            length2 = squareOf(gradient);
        }
        if (matter.gradientOpacity != nullptr) {
            const FloatV opacity = matter.gradientOpacityOf(length2);
            optics.extinction = matter.thinned(optics.extinction, opacity);
            if (m_.steep != nullptr) steep.extinction = matter.thinned(steep.extinction, opacity);
        }
        if (m_.steep != nullptr) {
            // mixedMatter() of cast.glsl.
            const FloatV isSteep = interpolated(gradients.steep, fraction);
            optics.extinction = mixed(optics.extinction, steep.extinction, isSteep);
            const FloatV share =
                hn::Div(hn::Mul(steep.extinction, isSteep), hn::Max(optics.extinction, hn::Set(f_, 1e-20f)));
            optics.r = mixed(optics.r, steep.r, share);
            optics.g = mixed(optics.g, steep.g, share);
            optics.b = mixed(optics.b, steep.b, share);
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
            gradient.z, direction.z, hn::MulAdd(gradient.y, direction.y, hn::Mul(gradient.x, direction.x)));
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
    Lanes3 colour_;
    FloatV transmittance_;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#endif
