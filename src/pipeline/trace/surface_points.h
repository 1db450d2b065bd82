// Points spread evenly over what can be seen of a volume: what the peripheral model is begun with.
//
// A place has points in proportion to its extinction times min(4 s, 1), where s is the part of all directions
// that it is seen from, as clip and mask leave it. So each point stands for the same area of an opaque
// surface, whichever way that faces (0.9 of its area count, as what lies deep is seen less), and for as much
// of translucent matter as has the same effect; what is seen from less than a quarter of all directions has
// fewer.
//
// They are drawn by rays even over all lines through the matter, which meet a place with a probability in
// proportion to extinction times s already. A weight makes good the rest, and of many candidates one is taken
// at even steps of weight along a curve through space. Faces of a clip that show grey values have as many
// points as the surface of dense matter, and these show that grey.
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
    std::uint32_t candidatesPerPoint = 4;  // to choose from; more are more evenly spread
};

inline constexpr std::uint32_t kMaxSurfacePoints = 1u << 20;

struct SurfacePoint {
    glm::vec3 positionMm{0.0f};  // relative to SurfacePoints::originMm, patient LPS
    // Linear, what leaves towards all directions on average, per unit of opacity: what a fully opaque pixel
    // there would show.
    glm::vec3 radiance{0.0f};
    float extinctionPerMm = 0.0f;  // mean over the ball of `radiusMm`
    float radiusMm = 0.0f;         // within which `spread` was measured
    glm::vec3 centreMm{0.0f};      // of the matter in it, relative to the point
    glm::mat3 spreadMm2{0.0f};     // its covariance around that centre
};

struct SurfacePoints {
    glm::dvec3 originMm{0.0};  // centre of the volume
    double areaMm2 = 0.0;      // what each point stands for
    std::vector<SurfacePoint> points;
    std::uint64_t lostPaths = 0;  // too long for the device, or not finite: their light is missing
};

// The search for surface points in what `scene` shows an eye. It finds at most `count`: fewer where matter is
// so faint or small that of 32 rays for each candidate too few meet it, and none when nothing can be seen.
// The same seed gives the same points on the same device. Used by one thread at a time, the one that uses the
// device.
class SurfacePointSearch {
  public:
    // usage when an option is out of its range.
    static Result<SurfacePointSearch> begin(const SceneView& scene, const SurfacePointOptions& options);
    SurfacePointSearch(SurfacePointSearch&&) noexcept;
    SurfacePointSearch& operator=(SurfacePointSearch&&) noexcept;
    ~SurfacePointSearch();

    bool isDone() const;
    // One dispatch of some 40 ms, while it is not done; waits. The scene must be the one that it began with,
    // looked at as it was then, and `kind` is of it.
    Result<void> step(const SceneView& scene, TraceKernels& kernels, SceneKind kind);
    // When it is done, once.
    SurfacePoints take();

  private:
    struct Impl;
    explicit SurfacePointSearch(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace macula::trace
