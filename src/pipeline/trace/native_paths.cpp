#include "pipeline/trace/native_paths.h"

#include <array>
#include <atomic>
#include <memory>

#include "base/parallel.h"
#include "pipeline/trace/native_film.h"
#include "pipeline/trace/native_tables.h"
#include "shared/primary_vertex.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/trace/native_paths.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>
// After it.
#include "pipeline/trace/path_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

// What path.comp writes besides the film; empty where the variant does not.
struct PathRecords {
    std::span<shared::PrimaryVertex> primaries;
    std::span<shared::IndirectRecord> records;
};

// The pixels of the planned blocks. Each lane owns a pixel until all its samples are done, so that sums are
// in the order of the samples.
class FilmPaths {
  public:
    FilmPaths(const NativeHost& host, const NativeFilm& film, const PathRecords& records,
              std::atomic<std::size_t>& nextPixel)
        : host_(host), film_(film), records_(records), nextPixel_(nextPixel) {}

    bool start(std::size_t lane, NativeHost::Path& path, NativeHost::Rng& rng) {
        Lane& l = lanes_[lane];
        if (l.sample == l.endSample) {
            if (!records_.records.empty()) tellIndirect(l);
            if (!takePixel(l)) return false;
        }
        path = host_.startSample(l.pixel, l.sample, rng);
        return true;
    }

    void endRay(std::size_t lane, const NativeHost::Path& path) {
        if (records_.primaries.empty() || path.vertices > 0 || path.shadow) return;
        lanes_[lane].metMm =
            path.direction * (path.transmittance > 0.0f ? path.walk.endMm : path.walk.distanceMm);
    }

    void endPath(std::size_t lane, const NativeHost::Path& path) {
        Lane& l = lanes_[lane];
        const glm::vec4 value(host_.lightOf(path), path.coverage);
        glm::vec4& sum = film_.sums[l.index];
        if (host_.isFinite(value) && host_.isFinite(sum + value)) {
            host_.accumulate(sum, film_.lost[l.index], value);
            host_.accumulate(film_.squares[l.index], host_.squareOfLuminance(glm::vec3(value)));
            film_.counts[l.index] += 1;
            if (path.cells.y != 0) l.record = {path.cells, path.radiance};
            if (!records_.primaries.empty()) tellPrimary(l, path, glm::vec3(value));
        } else {
            ++nonFinite_;
        }
        aboveBound_ += std::uint32_t(path.aboveBound);
        ++l.sample;
    }

    void end() {
        std::atomic_ref(film_.faults[0]) += nonFinite_;
        std::atomic_ref(film_.faults[2]) += aboveBound_;
    }

  private:
    struct Lane {
        glm::ivec2 pixel{0};
        std::size_t index = 0;  // of the pixel
        std::uint32_t sample = 0;
        std::uint32_t endSample = 0;
        glm::vec3 metMm{0.0f};  // where the sample met matter, relative to the eye
        shared::IndirectRecord record{};
    };

    bool takePixel(Lane& l) {
        const int columns = (host_.params.imageSize.x + shared::kBlockEdge - 1) / shared::kBlockEdge;
        constexpr std::size_t kPixels = shared::kBlockEdge * shared::kBlockEdge;
        l = {};
        for (std::size_t n = nextPixel_++; n < kPixels * film_.plan.size(); n = nextPixel_++) {
            const shared::PlannedBlock& planned = film_.plan[n / kPixels];
            const int block = int(planned.block);
            const int within = int(n % kPixels);
            l.pixel = shared::kBlockEdge * glm::ivec2(block % columns, block / columns) +
                      glm::ivec2(within % shared::kBlockEdge, within / shared::kBlockEdge);
            if (l.pixel.x >= host_.params.imageSize.x || l.pixel.y >= host_.params.imageSize.y ||
                planned.sampleCount == 0)
                continue;
            l.index = std::size_t(l.pixel.y) * std::size_t(host_.params.imageSize.x) + std::size_t(l.pixel.x);
            l.sample = planned.firstSample;
            l.endSample = planned.firstSample + planned.sampleCount;
            return true;
        }
        return false;
    }

    void tellPrimary(const Lane& l, const NativeHost::Path& path, const glm::vec3& radiance) const {
        const std::size_t pixels =
            std::size_t(host_.params.imageSize.x) * std::size_t(host_.params.imageSize.y);
        records_.primaries[l.sample % shared::kPrimarySamples * pixels + l.index] = {
            path.coverage > 0.0f ? l.metMm : glm::vec3(0.0f), radiance};
    }

    // As in shaders/trace/host.glsl.
    void tellIndirect(const Lane& l) const {
        const int stride = host_.params.indirectStride;
        const glm::ivec2 at = l.pixel + glm::ivec2(host_.params.seed % 61u, host_.params.seed % 59u);
        if (l.record.cells.y == 0 || at.x % stride != 0 || at.y % stride != 0) return;
        const glm::ivec2 place = l.pixel / stride;
        const int columns = (host_.params.imageSize.x + stride - 1) / stride;
        records_.records[std::size_t(place.y * columns + place.x)] = l.record;
    }

    NativeHost host_;
    NativeFilm film_;
    PathRecords records_;
    std::atomic<std::size_t>& nextPixel_;
    std::array<Lane, kFlights> lanes_{};
    std::uint32_t nonFinite_ = 0;
    std::uint32_t aboveBound_ = 0;
};

}  // namespace

void tracePaths(const gpu::NativeDispatch& dispatch, const TraceVariant& variant) {
    const shared::TraceParams& params = dispatch.binding<const shared::TraceParams>(0)[0];
    const HostTables<PooledVoxels> tables = nativeTables(dispatch, params, variant);
    const NativeHost host(tables, params, variant.filter);
    const NativeFilm film(dispatch);
    PathRecords records;
    if (variant.usesIndirect)
        records.records = dispatch.binding<shared::IndirectRecord>(kIndirectBinding + 2);
    if (variant.tellsPrimaries)
        records.primaries = dispatch.binding<shared::PrimaryVertex>(kIndirectBinding + 3);
    std::atomic<std::size_t> nextPixel{0};
    parallelFor(coreCount(), [&](std::size_t) {
        FilmPaths paths(host, film, records, nextPixel);
        std::make_unique<PathLanes<FilmPaths>>(host, tables, variant.filter, variant.scene.coarse, paths)
            ->work();
        paths.end();
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace macula::trace {

HWY_EXPORT(tracePaths);

gpu::NativeKernel nativePaths(const TraceVariant& variant) {
    if (variant.isSideBySide) return {};
    return [variant](const gpu::NativeDispatch& dispatch) {
        HWY_DYNAMIC_DISPATCH(tracePaths)(dispatch, variant);
    };
}

}  // namespace macula::trace
#endif
