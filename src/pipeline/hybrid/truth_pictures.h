// What a peripheral model is compared with: the same views, traced for as long as it takes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pipeline/hybrid/picture_cache.h"
#include "pipeline/hybrid/traced_scene.h"
#include "pipeline/hybrid/traced_view.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

struct TruthOptions {
    glm::ivec2 sizePx{512};
    std::uint32_t samplesPerPixel = 1024;  // every pixel has as many
    int bounces = 4;  // as the training views have: what fewer leave out is another matter
    double exposure = 1.0;
};

struct TruthPicture {
    TracedView view;
    // Standard error of it as it is displayed, black 0 to white 1, RMS over where there is something: no
    // model can come nearer to it than that.
    double noise = 0.0;
    bool fromCache = false;
};

// One for each camera, never denoised. What `cache` has is taken from there, and what is made is kept there
// at once, so that who is cancelled goes on where he was. `tracer` must have what `scene` is of; it is left
// with other settings and another view.
Result<std::vector<TruthPicture>> truthPictures(trace::PathTracer& tracer, const TracedScene& scene,
                                                std::span<const Camera> cameras, const TruthOptions& options,
                                                const PictureCache& cache, Progress& progress);

}  // namespace macula::hybrid
