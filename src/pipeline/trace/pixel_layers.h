// Where the light of each pixel of a picture comes from.
#pragma once

#include <memory>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/trace/scene_view.h"
#include "shared/pixel_layers.h"

namespace macula::trace {

// Of what the scene looks at, by layers.comp as compiled for it (TraceKernels); row 0 on top. Waits.
Result<std::vector<shared::PixelLayers>> findLayers(const std::shared_ptr<gpu::Device>& device,
                                                    const SceneView& scene, const gpu::Kernel& kernel,
                                                    int width, int height);

}  // namespace macula::trace
