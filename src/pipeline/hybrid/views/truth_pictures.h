// What a peripheral model is compared with: the same views, traced for as long as it takes.
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
    std::uint32_t samplesPerPixel = 1024;  // every pixel has as many; even: each half gets half of them
    int bounces =
        trace::kDefaultBounces;  // as the training views have: what fewer leave out is another matter
    double exposure = 1.0;
};

// Two pictures of one view, with independent noise.
struct TruthPicture {
    std::array<TracedView, 2> halves;
    bool fromCache = false;  // both

    const Camera& camera() const { return halves[0].camera; }
    const glm::ivec2& sizePx() const { return halves[0].sizePx; }
    // The picture of all samples: the mean of both halves.
    std::vector<glm::vec4> whole() const;
};

// One for each camera, never denoised. What `cache` has is taken from there, and what is made is kept there
// at once, each half by itself, so that who is cancelled goes on where he was. `tracer` must have what
// `scene` is of; it is left with other settings and another view. usage when the samples are not even.
Result<std::vector<TruthPicture>> truthPictures(trace::PathTracer& tracer, const TracedScene& scene,
                                                std::span<const Camera> cameras, const TruthOptions& options,
                                                const PictureCache& cache, Progress& progress);

}  // namespace macula::hybrid
