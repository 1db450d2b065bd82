#include "pipeline/splat/native/native_gather.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/splat/native/native_gather.cpp"
#include <hwy/foreach_target.h>  // first
#include <hwy/highway.h>

#include "pipeline/splat/native/vector_projection.h"

#ifndef MACULA_SPLAT_NATIVE_GATHER
#define MACULA_SPLAT_NATIVE_GATHER
namespace macula::splat {

// The bindings of gather.comp.
struct GatherWork {
    GatherWork(const gpu::NativeDispatch& dispatch, int degree_, int slots_)
        : frame(dispatch.binding<const shared::SplatFrame>(0).front()),
          screen(dispatch.binding<const float>(1).data()),
          parameters(dispatch.binding<const float>(2).data()),
          pairRanges(dispatch.binding<const glm::uvec2>(3).data()),
          pairs(dispatch.binding<const float>(4).data()),
          gradients(dispatch.binding<float>(5).data()),
          visible(dispatch.binding<std::uint32_t>(6).data()),
          statistics(dispatch.binding<shared::SplatStatistics>(7).data()),
          degree(degree_),
          slots(static_cast<std::size_t>(slots_)) {}

    shared::SplatFrame frame;
    const float* screen;
    const float* parameters;
    const glm::uvec2* pairRanges;
    const float* pairs;
    float* gradients;
    std::uint32_t* visible;
    shared::SplatStatistics* statistics;
    int degree;
    std::size_t slots;
};

}  // namespace macula::splat
#endif

HWY_BEFORE_NAMESPACE();
namespace macula::splat::HWY_NAMESPACE {
namespace {

constexpr std::size_t kSums = shared::kPairValues;
constexpr std::size_t kWeight = 9;  // of the sums: those that are no gradients
constexpr std::size_t kPull = 10;

// The sums over `count` times kSums numbers, one after the other as in the shader.
HWY_INLINE std::array<float, kSums> sumsOver(const float* from, std::size_t count) {
    static_assert(kSums == 11);
    const hn::CappedTag<float, 4> tag;
    std::array<float, kSums> result{};
    if constexpr (hn::MaxLanes(hn::CappedTag<float, 4>()) == 4) {
        // The last four begin with a number of those before them, so that nothing behind the buffer is read.
        auto first = hn::Zero(tag);
        auto next = hn::Zero(tag);
        auto last = hn::Zero(tag);
        for (const float* const end = from + count * kSums; from < end; from += kSums) {
            first = hn::Add(first, hn::LoadU(tag, from));
            next = hn::Add(next, hn::LoadU(tag, from + 4));
            last = hn::Add(last, hn::LoadU(tag, from + kSums - 4));
        }
        hn::StoreU(first, tag, result.data());
        hn::StoreU(next, tag, result.data() + 4);
        hn::StoreU(last, tag, result.data() + kSums - 4);
    } else {
        for (const float* const end = from + count * kSums; from < end; from += kSums)
            for (std::size_t k = 0; k < kSums; ++k) result[k] += from[k];
    }
    return result;
}

// Sums what the tiles found of the gradients of a vector of neighbouring splats, one splat in each lane.
class Gatherer {
  public:
    HWY_INLINE Gatherer(const GatherWork& work, std::size_t first, const Neighbours& splats)
        : w_(work), first_(first), splats_(splats) {}

    HWY_INLINE void run(const VectorModel::SplatView& view) {
        bool any = false;
        for (std::size_t lane = 0; lane < splats_.count; ++lane) any = sum(lane) || any;
        if (!any) return;
        VectorModel model({w_.degree, w_.parameters, w_.frame.capacity, splats_});
        VectorModel::ScreenSplat screen = model.noSplat();
        screen.conic = Vec3(loaded(conics_[0]), loaded(conics_[1]), loaded(conics_[2]));
        VectorModel::ScreenGradient g = model.noGradient();
        g.mean = Vec2(loaded(sums_[0]), loaded(sums_[1]));
        g.conic = Vec3(loaded(sums_[2]), loaded(sums_[3]), loaded(sums_[4]));
        g.opacity = loaded(sums_[5]);
        g.colour = Vec3(loaded(sums_[6]), loaded(sums_[7]), loaded(sums_[8]));
        write(model.parametersGradient(static_cast<int>(first_), view, screen, g));
    }

  private:
    static HWY_INLINE Float loaded(const Numbers& numbers) { return Float::load(numbers.data()); }

    // Sums over the pairs of a splat, and counts its statistics. Whether it shows.
    HWY_INLINE bool sum(std::size_t lane) {
        const std::size_t splat = first_ + lane;
        const glm::uvec2 range = w_.pairRanges[splat];
        const std::array<float, kSums> sums =
            sumsOver(w_.pairs + range.x * w_.slots * kSums, range.y * w_.slots);
        const bool shows = range.y > 0 && sums[kWeight] > 0.0f;
        w_.visible[splat] = shows ? 1 : 0;
        if (!shows) return false;
        shows_[lane] = 1.0f;
        for (std::size_t k = 0; k < kWeight; ++k) sums_[k][lane] = sums[k];
        const float* const texels = w_.screen + splat * std::size_t(shared::kScreenTexels) * 4;
        for (std::size_t k = 0; k < conics_.size(); ++k) conics_[k][lane] = texels[2 + k];
        shared::SplatStatistics& known = w_.statistics[splat];
        known.views += 1.0f;
        known.weight += sums[kWeight];
        known.pull += sums[kPull];
        known.mostWeight = std::max(known.mostWeight, sums[kWeight]);
        return true;
    }

    HWY_INLINE void write(const VectorModel::ParametersGradient& by) const {
        const VectorModel::SplatGradient& s = by.shape;
        const std::array<Float, shared::kSplatSh> values{
            s.position.x,   s.position.y, s.position.z, s.logScale.x, s.logScale.y,
            s.logScale.z,   s.rotation.x, s.rotation.y, s.rotation.z, s.rotation.w,
            s.opacityLogit, by.dc.x,      by.dc.y,      by.dc.z};
        write(values, 0);
        if (w_.degree != 1) return;
        const VectorModel::Band1Gradient& sh = by.sh;
        write(std::array<Float, 9>{sh.s1.x, sh.s1.y, sh.s1.z, sh.s2.x, sh.s2.y, sh.s2.z, sh.s3.x, sh.s3.y,
                                   sh.s3.z},
              shared::kSplatSh);
    }
    template <std::size_t kCount>
    HWY_INLINE void write(const std::array<Float, kCount>& values, std::size_t component) const {
        const Mask shows = loaded(shows_) > Float(0.0f);
        for (std::size_t k = 0; k < kCount; ++k)
            splats_.store(values[k], shows, w_.gradients + (component + k) * w_.frame.capacity + first_);
    }

    const GatherWork& w_;
    std::size_t first_;
    Neighbours splats_;
    Numbers shows_{};  // 1 where the splat shows
    std::array<Numbers, kWeight> sums_{};
    std::array<Numbers, 3> conics_{};
};

}  // namespace

void gatherGradients(const GatherWork& work) {
    const VectorModel::SplatView view = projectionOf(work.frame.view);
    forNeighbours(work.frame.count, [&](std::size_t first, const Neighbours& splats) {
        Gatherer(work, first, splats).run(view);
    });
}

}  // namespace macula::splat::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace macula::splat {

HWY_EXPORT(gatherGradients);

gpu::NativeKernel nativeGather(int degree, int slots) {
    return [degree, slots](const gpu::NativeDispatch& dispatch) {
        HWY_DYNAMIC_DISPATCH(gatherGradients)(GatherWork(dispatch, degree, slots));
    };
}

}  // namespace macula::splat
#endif
