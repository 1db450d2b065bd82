// The ground truth for a peripheral model: the same views, path traced with many samples.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "pipeline/hybrid/views/picture_cache.h"
#include "pipeline/hybrid/views/traced_scene.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

struct TruthOptions {
    glm::ivec2 sizePx{kTrainingSizePx};
    std::uint32_t samplesPerPixel = 1024;  // of every pixel; even, because each half gets half of them
    int bounces = trace::kDefaultBounces;  // as in training views: missing light is not an error here
    double exposure = 1.0;
};

// Two pictures of one view, with independent noise.
struct TruthPicture {
    std::array<TracedView, 2> halves;
    bool fromCache = false;  // both halves came from the cache

    const Camera& camera() const { return halves[0].camera; }
    const glm::ivec2& sizePx() const { return halves[0].sizePx; }
    // The picture of all samples: the mean of both halves.
    std::vector<glm::vec4> whole() const;
};

// One for each camera, never denoised. Takes halves from `cache`, and keeps each new one there at once, so
// that a cancelled run can continue where it was. `tracer` must have the contents of `scene`, and is left
// with other settings and another view. Fails with usage for an odd number of samples.
Result<std::vector<TruthPicture>> truthPictures(trace::PathTracer& tracer, const TracedScene& scene,
                                                std::span<const Camera> cameras, const TruthOptions& options,
                                                const PictureCache& cache, Progress& progress);

}  // namespace macula::hybrid
