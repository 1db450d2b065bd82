#include "pipeline/splat/native/native_adam.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/splat/native/native_adam.cpp"
#include <hwy/foreach_target.h>  // first
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>

#include "base/glsl_in_cpp.h"
#include "base/parallel.h"
#include "base/vector_in_glsl.h"
#include "shared/splat_adam_params.h"

HWY_BEFORE_NAMESPACE();
namespace macula::splat::HWY_NAMESPACE {

using namespace macula::HWY_NAMESPACE;

namespace {

#define float Float
#define bool Mask

struct VectorAdam : GlslInVectors {
#include "lib/splat_adam.glsl"
};

#undef float
#undef bool

struct SplatShape : GlslInCpp<float> {
#include "lib/splat_shape.glsl"
};

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

using Numbers = std::array<float, kLanes>;

// One number of each of a few neighbouring splats: fewer than a vector has lanes where there are no more.
struct Neighbours {
    std::size_t count;

    HWY_INLINE Float load(const float* from) const {
        if (count == kLanes) return Float::load(from);
        Numbers numbers{};
        std::copy_n(from, count, numbers.begin());
        return Float::load(numbers.data());
    }
    HWY_INLINE void store(Float value, Mask where, float* to) const {
        Numbers numbers;
        GlslInVectors::mix(load(to), value, where).store(numbers.data());
        std::copy_n(numbers.begin(), count, to);
    }
};

// A step for the splats from `first` on that showed.
class AdamStepper {
  public:
    HWY_INLINE AdamStepper(const AdamWork& work, std::size_t first)
        : w_(work), first_(first), splats_{std::min(kLanes, std::size_t(work.params.count) - first)} {
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
            const Float change =
                learnt(k, splats_.load(w_.gradients + at(k)), Float(w_.params.rates[k]), correction, usable);
            splats_.store(splats_.load(w_.parameters + at(k)) + change, usable, w_.parameters + at(k));
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
        std::array<SplatShape::SplatAxes, kLanes> axes;
        std::array<Numbers, 3> gradients{};
        std::array<Numbers, 3> rates{};
        for (std::size_t lane = 0; lane < splats_.count; ++lane) {
            const auto three = [&](const float* from, int component) {
                const float* const x = from + at(component) + lane;
                return glm::vec3(x[0], x[w_.params.capacity], x[2 * std::size_t(w_.params.capacity)]);
            };
            const glm::vec3 turn = three(w_.parameters, shared::kSplatRotation);
            axes[lane] = shape_.axesOf(
                shape_.unitQuaternion({turn, w_.parameters[at(shared::kSplatRotation + 3) + lane]}));
            const glm::vec3 along = shape_.alongAxes(axes[lane], three(w_.gradients, shared::kSplatPosition));
            const glm::vec3 deviations = shape_.deviationsMm(three(w_.parameters, shared::kSplatLogScale));
            for (int k = 0; k < 3; ++k) {
                gradients[std::size_t(k)][lane] = along[k];
                rates[std::size_t(k)][lane] = deviations[k] * w_.params.rates[shared::kSplatPosition + k];
            }
        }
        std::array<Numbers, 3> changes;
        for (int k = 0; k < 3; ++k)
            learnt(shared::kSplatPosition + k, Float::load(gradients[std::size_t(k)].data()),
                   Float::load(rates[std::size_t(k)].data()), correction, usable)
                .store(changes[std::size_t(k)].data());
        for (std::size_t lane = 0; lane < splats_.count; ++lane) {
            if (!(usable_[lane] > 0.0f)) continue;
            const glm::vec3 moved =
                shape_.fromAxes(axes[lane], {changes[0][lane], changes[1][lane], changes[2][lane]});
            for (int k = 0; k < 3; ++k) w_.parameters[at(shared::kSplatPosition + k) + lane] += moved[k];
        }
    }

    const AdamWork& w_;
    std::size_t first_;
    Neighbours splats_;
    VectorAdam maths_;
    SplatShape shape_;
    Numbers seen_{};    // 1 where the splat showed
    Numbers usable_{};  // and has finite gradients
    std::array<Numbers, 2> corrections_{};
};

}  // namespace

void stepAdam(const gpu::NativeDispatch& dispatch) {
    constexpr std::size_t kAtOnce = 1024;  // splats for a thread, a multiple of a vector's lanes
    const AdamWork work(dispatch);
    const std::size_t count = work.params.count;
    parallelFor((count + kAtOnce - 1) / kAtOnce, [&](std::size_t n) {
        const std::size_t end = std::min(count, (n + 1) * kAtOnce);
        for (std::size_t first = n * kAtOnce; first < end; first += kLanes) AdamStepper(work, first).run();
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
