#include "pipeline/splat/native/native_adam.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/splat/native/native_adam.cpp"
#include <hwy/foreach_target.h>  // first
#include <hwy/highway.h>

#include <atomic>

#include "pipeline/splat/native/neighbours.h"
#include "shared/splat_adam_params.h"

HWY_BEFORE_NAMESPACE();
namespace macula::splat::HWY_NAMESPACE {

namespace {

#define float Float
#define bool Mask

struct VectorAdam : GlslInVectors {
#include "lib/splat_adam.glsl"

#include "lib/splat_shape.glsl"
};

#undef float
#undef bool
#undef MAX_LOG_SCALE
#undef MIN_QUATERNION

// The bindings of adam.comp.
struct AdamWork {
    explicit AdamWork(const gpu::NativeDispatch& dispatch)
        : params(dispatch.binding<const shared::SplatAdamParams>(0).front()),
          corrections(dispatch.binding<const glm::vec2>(1).data()),
          gradients(dispatch.binding<const float>(2).data()),
          visible(dispatch.binding<const std::uint32_t>(3).data()),
          parameters(dispatch.binding<float>(4).data()),
          firsts(dispatch.binding<float>(5).data()),
          seconds(dispatch.binding<float>(6).data()),
          steps(dispatch.binding<std::uint32_t>(7).data()),
          skipped(dispatch.binding<std::uint32_t>(8).data()) {}

    shared::SplatAdamParams params;
    const glm::vec2* corrections;
    const float* gradients;
    const std::uint32_t* visible;
    float* parameters;
    float* firsts;
    float* seconds;
    std::uint32_t* steps;
    std::uint32_t* skipped;
};

// A step for those of neighbouring splats that showed.
class AdamStepper {
  public:
    HWY_INLINE AdamStepper(const AdamWork& work, std::size_t first, const Neighbours& splats)
        : w_(work), first_(first), splats_(splats) {
        for (std::size_t lane = 0; lane < splats_.count; ++lane)
            if (w_.visible[first_ + lane] != 0) seen_[lane] = 1.0f;
    }

    HWY_INLINE void run() {
        const Mask seen = Float::load(seen_.data()) > Float(0.0f);
        if (seen.none()) return;
        Mask usable = seen;
        for (int k = 0; k < w_.params.components; ++k)
            usable = usable && maths_.isUsableGradient(splats_.load(w_.gradients + at(k)));
        mixed(usable).store(usable_.data());
        for (std::size_t lane = 0; lane < splats_.count; ++lane) begin(lane);
        const Vec2 correction(Float::load(corrections_[0].data()), Float::load(corrections_[1].data()));
        // Positions first, along the axes for which the gradients were computed.
        movePositions(usable, correction);
        for (int k = shared::kSplatLogScale; k < w_.params.components; ++k) {
            move(k,
                 learnt(k, splats_.load(w_.gradients + at(k)), Float(w_.params.rates[k]), correction, usable),
                 usable);
        }
    }

  private:
    std::size_t at(int component) const { return std::size_t(component) * w_.params.capacity + first_; }
    static HWY_INLINE Float mixed(Mask usable) {
        return GlslInVectors::mix(Float(0.0f), Float(1.0f), usable);
    }

    // Counts the step of a splat, or the splat as skipped.
    void begin(std::size_t lane) {
        std::uint32_t& steps = w_.steps[first_ + lane];
        const glm::vec2 correction = w_.corrections[std::min(steps + 1, w_.params.lastCorrection)];
        corrections_[0][lane] = correction.x;
        corrections_[1][lane] = correction.y;
        if (usable_[lane] > 0.0f) {
            ++steps;
        } else if (seen_[lane] > 0.0f) {
            ++std::atomic_ref(*w_.skipped);
        }
    }

    // Updates the moments of a component, and returns the change of the parameter.
    HWY_INLINE Float learnt(int component, Float gradient, Float rate, Vec2 correction, Mask usable) {
        float* const first = w_.firsts + at(component);
        float* const second = w_.seconds + at(component);
        const auto next = maths_.adamStep(gradient, splats_.load(first), splats_.load(second), correction,
                                          rate, w_.params.beta1, w_.params.beta2, w_.params.epsilon);
        splats_.store(next.first, usable, first);
        splats_.store(next.second, usable, second);
        return next.change;
    }

    HWY_INLINE void movePositions(Mask usable, Vec2 correction) {
        const auto three = [&](const float* from, int component) {
            return Vec3(splats_.load(from + at(component)), splats_.load(from + at(component + 1)),
                        splats_.load(from + at(component + 2)));
        };
        constexpr int kFirst = shared::kSplatPosition;
        const Float w = splats_.load(w_.parameters + at(shared::kSplatRotation));
        const Vec3 turn = three(w_.parameters, shared::kSplatRotation + 1);
        const VectorAdam::SplatAxes axes = maths_.axesOf(maths_.unitQuaternion(Vec4(w, turn)));
        const Vec3 along = maths_.alongAxes(axes, three(w_.gradients, kFirst));
        const Vec3 rates = maths_.deviationsMm(three(w_.parameters, shared::kSplatLogScale)) *
                           Float(w_.params.rates[kFirst]);
        const Vec3 moved =
            maths_.fromAxes(axes, Vec3(learnt(kFirst, along.x, rates.x, correction, usable),
                                       learnt(kFirst + 1, along.y, rates.y, correction, usable),
                                       learnt(kFirst + 2, along.z, rates.z, correction, usable)));
        move(kFirst, moved.x, usable);
        move(kFirst + 1, moved.y, usable);
        move(kFirst + 2, moved.z, usable);
    }

    HWY_INLINE void move(int component, Float change, Mask usable) {
        float* const parameter = w_.parameters + at(component);
        splats_.store(splats_.load(parameter) + change, usable, parameter);
    }

    const AdamWork& w_;
    std::size_t first_;
    Neighbours splats_;
    VectorAdam maths_;
    Numbers seen_{};    // 1 where the splat showed
    Numbers usable_{};  // and has finite gradients
    std::array<Numbers, 2> corrections_{};
};

}  // namespace

void stepAdam(const gpu::NativeDispatch& dispatch) {
    const AdamWork work(dispatch);
    forNeighbours(work.params.count, [&](std::size_t first, const Neighbours& splats) {
        AdamStepper(work, first, splats).run();
    });
}

}  // namespace macula::splat::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace macula::splat {

HWY_EXPORT(stepAdam);

gpu::NativeKernel nativeAdam() {
    return [](const gpu::NativeDispatch& dispatch) { HWY_DYNAMIC_DISPATCH(stepAdam)(dispatch); };
}

}  // namespace macula::splat
#endif
