// Paths in the lanes of vectors: their rays fly together (flights-inl.h), and each path is decided in scalar
// code where its ray ends.
//
// Included once for each instruction set by Highway.
#if defined(MACULA_PATH_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_PATH_LANES_INL_H
#undef MACULA_PATH_LANES_INL_H
#else
#define MACULA_PATH_LANES_INL_H
#endif

#include <array>
#include <bit>

#include "pipeline/trace/native_host-inl.h"
// After it.
#include "pipeline/trace/flights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

// Follows the paths of a source, which one thread uses:
//   bool start(lane, path, rng)  starts the lane's next path; false when there is none left
//   void endRay(lane, path)      a ray has ended, before the path is decided
//   void endPath(lane, path)     the path is complete
template <class Source>
class PathLanes {
  public:
    PathLanes(const NativeHost& host, const HostTables<PooledVoxels>& tables, Filter filter, bool isCoarse,
              Source& source)
        : host_(host),
          source_(source),
          isMatterOfLanes_((filter == Filter::trilinear || filter == Filter::stochastic) &&
                           !host.useSecond() && !host.useTints()),
          tables_{.bounds = tables.bounds,
                  .matter = {tables, host.params, isCoarse, filter != Filter::stochastic},
                  .hasClip = host.useClip()} {}

    void work() {
        for (std::size_t lane = 0; lane < kFlights; ++lane) startPath(lane);
        while (busy_ > 0) {
            for (std::size_t first = 0; first < kFlights; first += hn::Lanes(Floats())) {
                std::uint32_t ended = advance(first);
                for (; ended != 0; ended &= ended - 1) endRay(first + std::size_t(std::countr_zero(ended)));
            }
        }
    }

  private:
    struct Lane {
        NativeHost::Path path;
        NativeHost::Rng rng;
        bool isBusy = false;
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
        if (isMatterOfLanes_) {
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

    // Collides a ray with matter that LaneMatter does not know.
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
        flights_.steep[lane] = path.steep;
        flights_.state[lane] = ends ? kEnded : kNewRay;
        if (++flights_.collisions[lane] > kMostCollisions) flights_.state[lane] = kEnded;
        // As Round::tighten().
        if (flights_.collisions[lane] == NativeHost::kStride) {
            flights_.majorant[lane] /= flights_.looseness[lane];
            flights_.looseness[lane] = 1.0f;
        }
        return flights_.state[lane] == kEnded;
    }

    void startPath(std::size_t lane) {
        Lane& l = lanes_[lane];
        const bool wasBusy = l.isBusy;
        l.isBusy = source_.start(lane, l.path, l.rng);
        busy_ += std::size_t(l.isBusy) - std::size_t(wasBusy);
        if (l.isBusy) {
            startRay(lane);
        } else {
            flights_.state[lane] = kIdle;
        }
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
        for (int cut = 0; cut < NativeHost::kCuts; ++cut) {
            f.cutFrom[cut][lane] = walk.cutFrom[cut];
            f.cutTo[cut][lane] = walk.cutTo[cut];
        }
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
        f.seesAll[lane] = host_.seesAll(path.shadow, path.vertices) ? 1 : 0;
        f.collisions[lane] = 0;
        f.aboveBound[lane] = 0;
        f.state[lane] = kNewRay;
    }

    void endRay(std::size_t lane) {
        Lane& l = lanes_[lane];
        l.path.walk.distanceMm = flights_.distanceMm[lane];
        l.path.transmittance = flights_.transmittance[lane];
        l.path.entry = flights_.entry[lane];
        if (tables_.matter.steep != nullptr) l.path.steep = flights_.steep[lane];
        l.path.aboveBound += flights_.aboveBound[lane];
        l.rng.counter = flights_.counter[lane];
        source_.endRay(lane, l.path);
        if (host_.decide(l.path, l.rng)) return startRay(lane);
        source_.endPath(lane, l.path);
        startPath(lane);
    }

    static constexpr int kMoves = 4;  // of a vector, before the next one's turn

    NativeHost host_;
    Source& source_;
    bool isMatterOfLanes_;
    FlightTables tables_;
    Flights flights_{};
    std::array<Lane, kFlights> lanes_{};
    std::size_t busy_ = 0;  // lanes with a path
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#endif
