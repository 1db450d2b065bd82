// The depths at which the centre ray of each pixel has lost an eighth more of its light
// (shaders/lib/layers.glsl).
#pragma once

#include <memory>
#include <optional>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/trace/scene_view.h"
#include "shared/pixel_layers.h"

namespace macula::trace {

// Finds them for the view of the scene, by layers.comp as compiled for that scene (TraceKernels): a
// shared::PixelLayers for each pixel, row 0 on top. A buffer of that size is used again: many
// views share one.
Result<void> findLayers(const std::shared_ptr<gpu::Device>& device, const SceneView& scene,
                        const gpu::Kernel& kernel, int width, int height, std::optional<gpu::Buffer>& layers);

}  // namespace macula::trace
