// Points spread evenly over the visible matter of a volume: the peripheral model starts with them.
//
// The density of points is proportional to extinction times min(4 s, 1), where s is the share of all
// directions from which a position is seen, with clip and mask in place. So each point stands for the same
// area of an opaque surface, whichever way it faces (0.9 of the area counts, because deeper parts are seen
// less), or for translucent matter of the same effect; matter seen from less than a quarter of all directions
// has fewer points.
//
// Candidates come from rays distributed evenly over all lines through the matter, which meet a position with
// a probability proportional to extinction times s. A weight makes up the difference, and points are chosen
// from many candidates at even steps of weight along a space-filling curve. Clip faces that show grey values
// have as many points as the surface of dense matter, and these show that grey.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "base/result.h"
#include "pipeline/trace/trace_kernels.h"

namespace macula::trace {

class SceneView;

struct SurfacePointOptions {
    std::uint32_t count = 10000;           // 1 to kMaxSurfacePoints
    std::uint32_t paths = 32;              // light paths for each point; rounded up to a multiple of 32
    std::uint32_t candidatesPerPoint = 4;  // candidates to choose from; more make points more even
};

inline constexpr std::uint32_t kMaxSurfacePoints = 1u << 20;

struct SurfacePoint {
    glm::vec3 positionMm{0.0f};  // relative to SurfacePoints::originMm, patient LPS
    // Linear, leaving the point, averaged over all directions, per unit of opacity: what a fully opaque pixel
    // there would show.
    glm::vec3 radiance{0.0f};
    float extinctionPerMm = 0.0f;  // mean over a ball of `radiusMm`
    float radiusMm = 0.0f;         // within which `spread` was measured
    glm::vec3 centreMm{0.0f};      // of the matter in that ball, relative to the point
    glm::mat3 spreadMm2{0.0f};     // its covariance around that centre
};

struct SurfacePoints {
    glm::dvec3 originMm{0.0};  // centre of the volume
    double areaMm2 = 0.0;      // that each point stands for
    std::vector<SurfacePoint> points;
    std::uint64_t lostPaths = 0;  // too long for the device, or not finite: their light is missing
};

// The search for surface points on the visible matter of `scene`. It finds at most `count`: fewer where
// matter is so faint or small that too few of 32 rays for each candidate meet it, and none when nothing is
// visible. The same seed gives the same points on the same device. Used by one thread at a time, the one that
// uses the device.
class SurfacePointSearch {
  public:
    // usage when an option is out of its range.
    static Result<SurfacePointSearch> begin(const SceneView& scene, const SurfacePointOptions& options);
    SurfacePointSearch(SurfacePointSearch&&) noexcept;
    SurfacePointSearch& operator=(SurfacePointSearch&&) noexcept;
    ~SurfacePointSearch();

    bool isDone() const;
    // One dispatch of some 40 ms, while it is not done; waits. Scene and view must be those with which the
    // search began; `kind` describes that scene.
    Result<void> step(const SceneView& scene, TraceKernels& kernels, SceneKind kind);
    // When it is done, once.
    SurfacePoints take();

  private:
    struct Impl;
    explicit SurfacePointSearch(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace macula::trace
