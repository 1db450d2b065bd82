// Makes the request for the picture that a pane of slices is to show.
#pragma once

#include <glm/glm.hpp>
#include <memory>

#include "viewer/slices/pane_content.h"
#include "viewer/slices/slice_sampler.h"

namespace macula::viewer {

// Needs a study. With a second volume in its place or over it, as the state has it. `segments` are of the
// study; null: none. `sizePx` in logical pixels, `pixelRatio` device pixels to each.
SliceRequest requestFor(const PaneContent& content, const PaneView& view,
                        std::shared_ptr<const slices::ShownSegments> segments, const glm::ivec2& sizePx,
                        double pixelRatio);

}  // namespace macula::viewer
