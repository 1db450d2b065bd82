// Cast rays in the lanes of a vector. At any time lanes wait for different kinds of work, which is done for
// all lanes that wait for it when these are enough.
//
// Included once for each instruction set by Highway, in macula::trace and its HWY_NAMESPACE; needs
// NativeHost.
#if defined(MACULA_CAST_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_CAST_LANES_INL_H
#undef MACULA_CAST_LANES_INL_H
#else
#define MACULA_CAST_LANES_INL_H
#endif

#include <bit>
#include <span>

#include "pipeline/trace/cast_matter-inl.h"
#include "pipeline/trace/cast_values-inl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

// Casts the rays of a source, which one thread uses:
//   bool start(lane, pixel, sample)  starts the lane's next ray; false when there is none left
//   void end(lane, value)            the ray's value, as that of castSample()
template <class Source>
class CastLanes {
  public:
    // `nextMatter` is that of CastMatterTables, for matter alone.
    CastLanes(const NativeHost& host, const HostTables<PooledVoxels>& tables, bool isCoarse,
              std::span<const std::int32_t> nextMatter, Source& source)
        : host_(host),
          source_(source),
          tables_{.bounds = tables.bounds,
                  .matter = {tables, host.params, isCoarse, true},
                  .hasClip = host.useClip(),
                  .look = host.castLook(),
                  .entryCount = host.params.entryCount},
          matter_{.flat = &tables.albedo->x,
                  .steep = tables.steep.empty() ? nullptr : &tables.steep.data()->x,
                  .nextMatter = nextMatter.data(),
                  .isShaded = host.useShading(),
                  .stepsPerEntry = host.params.stepsPerEntry,
                  .ambient = host.params.ambient,
                  .diffuse = host.params.diffuse},
          copies_(tables.voxels, host.params.volumeSize, host_.hasGradients() ? 1 : 0) {}

    void work() {
        for (std::size_t lane = 0; lane < hn::Lanes(Floats()); ++lane) startRay(lane);
        while (busy_ > 0) {
            const std::size_t seeking = count(kSeeking);
            if (seeking >= kEnoughSeeking || seeking == busy_) {
                seek();
            } else {
                cross();
            }
            for (std::uint32_t done = lanesOf(kDone); done != 0; done &= done - 1)
                endRay(std::size_t(std::countr_zero(done)));
        }
    }

  private:
    CopiedVoxels voxels() const { return {copies_.values()}; }

    std::size_t count(Casting state) const { return countIn(hn::Load(Ints(), rays_.state), state); }

    // As bits.
    std::uint32_t lanesOf(Casting state) const {
        return bitsOf(lanesIn(hn::Load(Ints(), rays_.state), state));
    }

    void cross() {
        switch (tables_.look) {
            case shared::kCastMaximum:
                return values().template cross<shared::kCastMaximum>(kEnough);
            case shared::kCastMinimum:
                return values().template cross<shared::kCastMinimum>(kEnough);
            case shared::kCastMean:
                return values().template cross<shared::kCastMean>(kEnough);
            default:
                return CastMatter(rays_, tables_, matter_, voxels()).cross(kEnough);
        }
    }
    CastValues values() { return {rays_, tables_, voxels(), host_.params.paddingEntry}; }

    // Finds the next bricks of rays, and enters them.
    void seek() {
        BrickSearch(rays_, tables_).run(kEnoughSeeking);
        const std::uint32_t found = lanesOf(kFound);
        if (found == 0) return;
        for (std::uint32_t left = found; left != 0; left &= left - 1)
            holdBrick(std::size_t(std::countr_zero(left)));
        LaneCells cells(rays_);
        const Ints i;
        const IntV state = hn::Load(i, rays_.state);
        const auto entering = lanesIn(state, kFound);
        cells.enter(floatMask(entering));
        cells.store();
        hn::Store(moved(state, entering, kCrossing), i, rays_.state);
    }

    // enterBrick() of cell_walk.glsl.
    void holdBrick(std::size_t lane) {
        const float middle = 0.5f * (rays_.distanceMm[lane] + rays_.pieceEndMm[lane]);
        const auto brickAt = [&](const float* origin, const float* direction, int count) {
            return int(
                std::clamp(std::floor(origin[lane] + direction[lane] * middle), 0.0f, float(count - 1)));
        };
        const glm::ivec3& grid = host_.params.gridSize;
        const RayVector& from = rays_.origin;
        const RayVector& along = rays_.direction;
        const glm::ivec3 brick{brickAt(from.x, along.x, grid.x), brickAt(from.y, along.y, grid.y),
                               brickAt(from.z, along.z, grid.z)};
        rays_.copy[lane] = copies_.hold(lane, brick);
        rays_.firstCell.set(lane, glm::vec3(NativeHost::kBrickEdge * brick - 1));
    }

    void startRay(std::size_t lane) {
        glm::ivec2 pixel(0);
        std::uint32_t sample = 0;
        const bool wasBusy = rays_.state[lane] != kNoRay;
        const bool isBusy = source_.start(lane, pixel, sample);
        busy_ += std::size_t(isBusy) - std::size_t(wasBusy);
        rays_.state[lane] = isBusy ? kSeeking : kNoRay;
        if (!isBusy) return;
        const glm::vec3 offset = host_.castOffset(sample);
        const NativeHost::EyeRay eye = host_.eyeRay(glm::vec2(pixel) + glm::vec2(offset));
        const glm::vec3 direction = host_.voxelsPerMm(eye.direction);
        NativeHost::BrickWalk walk = host_.startEyeWalk(eye.originVoxel, direction);
        rays_.face[lane] = 0.0f;
        if (tables_.look == shared::kCastMatter && host_.useClip() && host_.params.greyFaces != 0)
            rays_.face[lane] = host_.stopAtFace(walk, eye.originVoxel, direction);
        setWalk(lane, walk);
        rays_.voxelOrigin.set(lane, eye.originVoxel - glm::vec3(0.5f));
        rays_.voxelDirection.set(lane, direction);
        rays_.voxelInverse.set(lane, {host_.safeInverse(direction.x), host_.safeInverse(direction.y),
                                      host_.safeInverse(direction.z)});
        rays_.worldDirection.set(lane, eye.direction);
        rays_.colour.set(lane, glm::vec3(0.0f));
        rays_.transmittance[lane] = 1.0f;
        rays_.phase[lane] = offset.z;
        rays_.step[lane] = 0.0f;
        rays_.best[lane] = -1e9f;
        rays_.sum[lane] = 0.0f;
        rays_.lengthMm[lane] = 0.0f;
    }

    void setWalk(std::size_t lane, const NativeHost::BrickWalk& walk) {
        rays_.origin.set(lane, walk.origin);
        rays_.direction.set(lane, walk.direction);
        rays_.inverse.set(lane, walk.inverse);
        rays_.brick.set(lane, walk.cell);
        for (int cut = 0; cut < NativeHost::kCuts; ++cut) {
            rays_.cutFrom[cut][lane] = walk.cutFrom[cut];
            rays_.cutTo[cut][lane] = walk.cutTo[cut];
        }
        rays_.distanceMm[lane] = walk.distanceMm;
        rays_.endMm[lane] = walk.endMm;
        rays_.segmentEndMm[lane] = walk.segmentEndMm;
        rays_.majorant[lane] = walk.majorant;
        rays_.segments[lane] = 0;
    }

    void endRay(std::size_t lane) {
        const glm::vec3 colour{rays_.colour.x[lane], rays_.colour.y[lane], rays_.colour.z[lane]};
        source_.end(lane, tables_.look == shared::kCastMatter
                              ? host_.endOfMatter(colour, rays_.transmittance[lane], rays_.face[lane])
                              : host_.endOfValues(rays_.best[lane], rays_.sum[lane], rays_.lengthMm[lane]));
        startRay(lane);
    }

    // Fewer lanes than these wait for others to join them.
    static constexpr std::size_t kEnoughSeeking = (hn::MaxLanes(Floats()) + 3) / 4;
    static constexpr std::size_t kEnough = (hn::MaxLanes(Floats()) + 1) / 2;

    NativeHost host_;
    Source& source_;
    CastTables tables_;
    CastMatterTables matter_;
    BrickCopies copies_;
    CastRays rays_{};
    std::size_t busy_ = 0;  // lanes with a ray
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#endif
