// A picture from a side that no light need have been traced for: coverage as the guides find it, and light
// from the radiance cache of the traced views (light_in_space.h) where its rays meet matter. It costs a small
// part of what tracing does, and teaches a model how what it knows looks from many more sides than it has
// pictures of.
#pragma once

#include "base/result.h"
#include "pipeline/hybrid/light/light_in_space.h"
#include "pipeline/hybrid/views/traced_view.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

// The picture has no samples. Where matter is seen that no traced view has come near, pixels are NaN: not
// known. `tracer` is left with another view.
Result<TracedView> litView(trace::PathTracer& tracer, const Camera& camera, const glm::ivec2& sizePx,
                           const LightInSpace& light);

}  // namespace macula::hybrid
