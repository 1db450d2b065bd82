// Makes the request for the picture that a pane of slices is to show.
#pragma once

#include <glm/glm.hpp>
#include <memory>

#include "viewer/slices/pane_content.h"
#include "viewer/slices/slice_sampler.h"

namespace macula::viewer {

// Needs a study. The request has the second volume instead of the study or over it, if the state says so.
// `segments` belong to the study; null: none. `sizePx` in logical pixels, `pixelRatio` device pixels to each.
SliceRequest requestFor(const PaneContent& content, const PaneView& view,
                        std::shared_ptr<const slices::ShownSegments> segments, const glm::ivec2& sizePx,
                        double pixelRatio);

}  // namespace macula::viewer
