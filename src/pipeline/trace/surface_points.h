// Points spread evenly over what can be seen of a volume: what the peripheral model is begun with.
//
// They are chosen on the matter itself and not on rays: a place has points in proportion to its extinction,
// as far as it is seen from an eighth of all directions or more. So each point stands for the same area of an
// opaque surface, whichever way that faces, and for as much of translucent matter as has the same effect.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "base/result.h"
#include "pipeline/trace/trace_kernels.h"

namespace macula::trace {

class DeviceScene;

struct SurfacePointOptions {
    std::uint32_t count = 10000;           // 1 to kMaxSurfacePoints
    std::uint32_t paths = 32;              // of light, for each point; rounded up to a multiple of 8
    std::uint32_t candidatesPerPoint = 8;  // that are seen, to choose from; more are more evenly spread
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
};

// Of what `scene` looks at, as an eye is shown it; at most `count`, none when nothing can be seen. Waits.
// `keepGoing` (may be empty) is asked between dispatches of some 40 ms; cancelled when it says no.
Result<SurfacePoints> findSurfacePoints(const std::shared_ptr<gpu::Device>& device, const DeviceScene& scene,
                                        TraceKernels& kernels, SceneKind kind,
                                        const SurfacePointOptions& options,
                                        const std::function<bool()>& keepGoing);

}  // namespace macula::trace
