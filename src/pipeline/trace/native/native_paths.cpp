#include "pipeline/trace/native/native_paths.h"

#include <array>
#include <atomic>
#include <bit>
#include <memory>

#include "base/glsl_in_cpp.h"
#include "base/parallel.h"
#include "pipeline/trace/clip_params.h"
#include "pipeline/trace/native/native_film.h"
#include "pipeline/trace/native/native_tables.h"
#include "shared/indirect_light.h"
#include "shared/primary_vertex.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/trace/native/native_paths.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>
// After highway.h.
#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {
#define MACULA_HOST NativeHost
#define MACULA_REAL float
#define MACULA_VOXELS PooledVoxels
#include "pipeline/trace/shader_host.inl"
#undef MACULA_HOST
#undef MACULA_REAL
#undef MACULA_VOXELS
}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#include "pipeline/trace/native/flights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

// What path.comp writes besides the film; empty where the variant does not.
struct PathRecords {
    std::span<shared::PrimaryVertex> primaries;
    std::span<shared::IndirectRecord> records;
};

// Does all pixels of the planned blocks. Each lane owns a pixel until all its samples are done, so that sums
// are in the order of the samples.
class PathWorker {
  public:
    PathWorker(const NativeHost& host, const TraceVariant& variant, const NativeFilm& film,
               const PathRecords& records, const FlightTables& tables, std::atomic<std::size_t>& nextPixel)
        : host_(host),
          film_(film),
          records_(records),
          nextPixel_(nextPixel),
          matterIsOfValue_((variant.filter == Filter::trilinear || variant.filter == Filter::stochastic) &&
                           !host.useMask() && !host.useSecond() && !host.useTints() &&
                           !host.useGradientOpacity() && !host.useSteepDensity()),
          tables_(tables) {
        for (std::size_t lane = 0; lane < kFlights; ++lane) {
            flights_.state[lane] = kIdle;
            nextPixelOf(lane);
        }
    }

    void work() {
        while (busy_ > 0) {
            for (std::size_t first = 0; first < kFlights; first += hn::Lanes(Floats())) {
                std::uint32_t ended = advance(first);
                for (; ended != 0; ended &= ended - 1) endRay(first + std::size_t(std::countr_zero(ended)));
            }
        }
        std::atomic_ref(film_.faults[0]) += nonFinite_;
        std::atomic_ref(film_.faults[2]) += aboveBound_;
    }

  private:
    // The pixel of a lane, and its path.
    struct Lane {
        NativeHost::Path path;
        NativeHost::Rng rng;
        glm::ivec2 pixel{0};
        std::size_t index = 0;  // of the pixel
        std::uint32_t sample = 0;
        std::uint32_t endSample = 0;
        glm::vec3 metMm{0.0f};  // where the sample met matter, relative to the eye
        shared::IndirectRecord record{};
    };

    // Moves the rays of a vector, and collides them when enough of them have come to a collision. Returns the
    // lanes whose ray has ended.
    std::uint32_t advance(std::size_t first) {
        if (isIdle(flights_, first)) return 0;
        Round round(flights_, tables_, first);
        round.drawDepths();
        for (int i = 0; i < kMoves && round.anyMoving(); ++i) round.move();
        const bool waits = round.anyMoving() && 2 * round.countMet() < hn::Lanes(Floats());
        if (waits) return round.store();
        if (matterIsOfValue_) {
            round.collide();
            return round.store();
        }
        std::uint32_t ended = round.store();
        for (std::uint32_t met = round.metLanes(); met != 0; met &= met - 1) {
            const auto lane = std::size_t(std::countr_zero(met));
            if (collide(first + lane)) ended |= 1u << lane;
        }
        return ended;
    }

    // Collides a ray with matter that depends on more than the volume's value.
    bool collide(std::size_t lane) {
        NativeHost::Path& path = lanes_[lane].path;
        NativeHost::Rng& rng = lanes_[lane].rng;
        path.walk.distanceMm = flights_.distanceMm[lane];
        path.walk.majorant = flights_.majorant[lane];
        rng.counter = flights_.counter[lane];
        const bool ends = host_.collide(path, rng);
        flights_.counter[lane] = rng.counter;
        flights_.transmittance[lane] = path.transmittance;
        flights_.entry[lane] = path.entry;
        flights_.state[lane] = ends ? kEnded : kNewRay;
        if (++flights_.collisions[lane] == NativeHost::kStride) {
            flights_.majorant[lane] /= flights_.looseness[lane];
            flights_.looseness[lane] = 1.0f;
        }
        return ends;
    }

    void startRay(std::size_t lane) {
        const NativeHost::Path& path = lanes_[lane].path;
        const NativeHost::BrickWalk& walk = path.walk;
        const NativeHost::Rng& rng = lanes_[lane].rng;
        Flights& f = flights_;
        f.origin.set(lane, walk.origin);
        f.direction.set(lane, walk.direction);
        f.inverse.set(lane, walk.inverse);
        f.cell.set(lane, walk.cell);
        f.cutFrom.set(lane, walk.cutFrom);
        f.cutTo.set(lane, walk.cutTo);
        f.distanceMm[lane] = walk.distanceMm;
        f.endMm[lane] = walk.endMm;
        f.segmentEndMm[lane] = walk.segmentEndMm;
        f.majorant[lane] = walk.majorant;
        f.looseness[lane] = walk.looseness;
        f.transmittance[lane] = path.transmittance;
        f.key0[lane] = rng.key0;
        f.key1[lane] = rng.key1;
        f.counter[lane] = rng.counter;
        f.isShadow[lane] = path.shadow ? 1 : 0;
        f.collisions[lane] = 0;
        f.aboveBound[lane] = 0;
        f.state[lane] = kNewRay;
    }

    void endRay(std::size_t lane) {
        Lane& l = lanes_[lane];
        l.path.walk.distanceMm = flights_.distanceMm[lane];
        l.path.transmittance = flights_.transmittance[lane];
        l.path.entry = flights_.entry[lane];
        l.path.aboveBound += flights_.aboveBound[lane];
        l.rng.counter = flights_.counter[lane];
        if (!records_.primaries.empty() && l.path.vertices == 0 && !l.path.shadow)
            l.metMm =
                l.path.direction * (l.path.transmittance > 0.0f ? l.path.walk.endMm : l.path.walk.distanceMm);
        if (host_.decide(l.path, l.rng)) return startRay(lane);
        endSample(l);
        if (l.sample < l.endSample) return startSample(lane);
        if (!records_.records.empty()) tellIndirect(l);
        --busy_;
        nextPixelOf(lane);
    }

    void endSample(Lane& l) {
        const glm::vec4 value(host_.lightOf(l.path), l.path.coverage);
        glm::vec4& sum = film_.sums[l.index];
        if (host_.isFinite(value) && host_.isFinite(sum + value)) {
            host_.accumulate(sum, film_.lost[l.index], value);
            host_.accumulate(film_.squares[l.index], host_.squareOfLuminance(glm::vec3(value)));
            film_.counts[l.index] += 1;
            if (l.path.cells.y != 0) l.record = {l.path.cells, l.path.radiance};
            if (!records_.primaries.empty()) tellPrimary(l, glm::vec3(value));
        } else {
            ++nonFinite_;
        }
        aboveBound_ += std::uint32_t(l.path.aboveBound);
        ++l.sample;
    }

    void tellPrimary(const Lane& l, const glm::vec3& radiance) const {
        const std::size_t pixels =
            std::size_t(host_.params.imageSize.x) * std::size_t(host_.params.imageSize.y);
        records_.primaries[l.sample % shared::kPrimarySamples * pixels + l.index] = {
            l.path.coverage > 0.0f ? l.metMm : glm::vec3(0.0f), radiance};
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

    void startSample(std::size_t lane) {
        Lane& l = lanes_[lane];
        l.path = host_.startSample(l.pixel, l.sample, l.rng);
        startRay(lane);
    }

    void nextPixelOf(std::size_t lane) {
        flights_.state[lane] = kIdle;
        Lane& l = lanes_[lane];
        const int columns = (host_.params.imageSize.x + shared::kBlockEdge - 1) / shared::kBlockEdge;
        constexpr std::size_t kPixels = shared::kBlockEdge * shared::kBlockEdge;
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
            l.record = {};
            ++busy_;
            return startSample(lane);
        }
    }

    static constexpr int kMoves = 4;  // of a vector, before the next one's turn

    NativeHost host_;
    NativeFilm film_;
    PathRecords records_;
    std::atomic<std::size_t>& nextPixel_;
    bool matterIsOfValue_;
    FlightTables tables_;
    Flights flights_{};
    std::array<Lane, kFlights> lanes_{};
    std::size_t busy_ = 0;  // lanes with a pixel
    std::uint32_t nonFinite_ = 0;
    std::uint32_t aboveBound_ = 0;
};

}  // namespace

void tracePaths(const gpu::NativeDispatch& dispatch, const TraceVariant& variant) {
    const shared::TraceParams& params = dispatch.binding<const shared::TraceParams>(0)[0];
    const HostTables<PooledVoxels> tables = nativeTables(dispatch, params, variant);
    const NativeHost host(tables, params, variant.filter);
    const FlightTables flightTables{.bounds = tables.bounds,
                                    .extinction = tables.extinctionPerMm,
                                    .words = reinterpret_cast<const std::int32_t*>(tables.voxels.words),
                                    .pool = reinterpret_cast<const std::int32_t*>(tables.voxels.pool),
                                    .grid = params.gridSize,
                                    .size = params.volumeSize,
                                    .hasClip = host.useClip(),
                                    .isCoarse = variant.scene.coarse,
                                    .isTrilinear = variant.filter != Filter::stochastic};
    const NativeFilm film(dispatch);
    PathRecords records;
    if (variant.usesIndirect)
        records.records = dispatch.binding<shared::IndirectRecord>(kIndirectBinding + 2);
    if (variant.tellsPrimaries)
        records.primaries = dispatch.binding<shared::PrimaryVertex>(kIndirectBinding + 3);
    std::atomic<std::size_t> nextPixel{0};
    parallelFor(coreCount(), [&](std::size_t) {
        std::make_unique<PathWorker>(host, variant, film, records, flightTables, nextPixel)->work();
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
