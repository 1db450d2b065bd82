#include "pipeline/trace/native_casts.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "base/parallel.h"
#include "pipeline/trace/native_film.h"
#include "pipeline/trace/native_tables.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/trace/native_casts.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>
// After it, in this order.
#include "pipeline/trace/native_host-inl.h"

#include "pipeline/trace/cast_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

// The pixels of planned blocks, each block for one thread, so that its rays share copies of bricks. Each lane
// owns a pixel until all its samples are done, so that sums are in the order of the samples.
class FilmCasts {
  public:
    FilmCasts(const NativeHost& host, const NativeFilm& film, std::atomic<std::size_t>& nextBlock)
        : host_(host),
          film_(film),
          nextBlock_(nextBlock),
          run_(std::clamp<std::size_t>(film.plan.size() / (4 * coreCount()), 1, kMostRun)) {}

    bool start(std::size_t lane, glm::ivec2& pixel, std::uint32_t& sample) {
        Lane& l = lanes_[lane];
        if (l.sample == l.endSample && !takePixel(l)) return false;
        pixel = l.pixel;
        sample = l.sample;
        return true;
    }

    void end(std::size_t lane, const glm::vec4& value) {
        Lane& l = lanes_[lane];
        glm::vec4& sum = film_.sums[l.index];
        if (host_.isFinite(value) && host_.isFinite(sum + value)) {
            host_.accumulate(sum, film_.lost[l.index], value);
            host_.accumulate(film_.squares[l.index], host_.squareOfLuminance(glm::vec3(value)));
            film_.counts[l.index] += 1;
        } else {
            ++nonFinite_;
        }
        ++l.sample;
    }

    void end() { std::atomic_ref(film_.faults[0]) += nonFinite_; }

  private:
    static constexpr int kPixels = shared::kBlockEdge * shared::kBlockEdge;
    static constexpr std::size_t kMostRun = 4;

    struct Lane {
        glm::ivec2 pixel{0};
        std::size_t index = 0;  // of the pixel
        std::uint32_t sample = 0;
        std::uint32_t endSample = 0;
    };

    bool takePixel(Lane& l) {
        const glm::ivec2& size = host_.params.imageSize;
        for (;; ++pixel_) {
            if (pixel_ == kPixels) {
                ++block_;
                pixel_ = 0;
            }
            if (block_ == endBlock_) {
                block_ = nextBlock_.fetch_add(run_);
                endBlock_ = block_ + run_;
            }
            if (block_ >= film_.plan.size()) return false;
            const shared::PlannedBlock& planned = film_.plan[block_];
            const int columns = (size.x + shared::kBlockEdge - 1) / shared::kBlockEdge;
            const int block = int(planned.block);
            l.pixel = shared::kBlockEdge * glm::ivec2(block % columns, block / columns) +
                      glm::ivec2(pixel_ % shared::kBlockEdge, pixel_ / shared::kBlockEdge);
            if (l.pixel.x >= size.x || l.pixel.y >= size.y || planned.sampleCount == 0) continue;
            l.index = std::size_t(l.pixel.y) * std::size_t(size.x) + std::size_t(l.pixel.x);
            l.sample = planned.firstSample;
            l.endSample = planned.firstSample + planned.sampleCount;
            ++pixel_;
            return true;
        }
    }

    NativeHost host_;
    NativeFilm film_;
    std::atomic<std::size_t>& nextBlock_;
    std::size_t run_;  // blocks that this thread takes at once
    std::array<Lane, kRays> lanes_{};
    std::size_t block_ = 0;  // in the plan
    std::size_t endBlock_ = 0;
    int pixel_ = 0;  // of the block, the next one
    std::uint32_t nonFinite_ = 0;
};

// CastMatterTables::nextMatter.
std::vector<std::int32_t> nextMatterOf(const HostTables<PooledVoxels>& tables, int entryCount) {
    std::vector<std::int32_t> next(std::size_t(entryCount), entryCount);
    for (std::size_t entry = next.size(); entry-- > 0;) {
        const bool has =
            tables.albedo[entry].w != 0.0f || (!tables.steep.empty() && tables.steep[entry].w != 0.0f);
        next[entry] = has ? int(entry) : entry + 1 < next.size() ? next[entry + 1] : 2 * entryCount;
    }
    return next;
}

}  // namespace

void castRays(const gpu::NativeDispatch& dispatch, const TraceVariant& variant, int look) {
    const shared::TraceParams& params = dispatch.binding<const shared::TraceParams>(0)[0];
    const HostTables<PooledVoxels> tables = nativeTables(dispatch, params, variant);
    NativeHost host(tables, params, variant.filter);
    host.cast = {look, variant.shading};
    const NativeFilm film(dispatch);
    const std::vector<std::int32_t> nextMatter =
        look == shared::kCastMatter ? nextMatterOf(tables, params.entryCount) : std::vector<std::int32_t>{};
    std::atomic<std::size_t> nextBlock{0};
    parallelFor(coreCount(), [&](std::size_t) {
        FilmCasts casts(host, film, nextBlock);
        std::make_unique<CastLanes<FilmCasts>>(host, tables, variant.scene.coarse, nextMatter, casts)->work();
        casts.end();
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace macula::trace {

HWY_EXPORT(castRays);

gpu::NativeKernel nativeCasts(const TraceVariant& variant, int look) {
    const bool isSpline = variant.filter == Filter::smooth || variant.filter == Filter::sharp;
    if (isSpline || variant.scene.second || variant.scene.tints) return {};
    return [variant, look](const gpu::NativeDispatch& dispatch) {
        HWY_DYNAMIC_DISPATCH(castRays)(dispatch, variant, look);
    };
}

}  // namespace macula::trace
#endif
