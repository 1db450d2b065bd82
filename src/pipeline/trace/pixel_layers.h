// The depths of eight layers along the centre ray of each pixel, each of which takes an eighth of the ray's
// light (shaders/lib/layers.glsl).
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

// Finds the layers for the view of the scene, by layers.comp as compiled for that scene (TraceKernels): a
// shared::PixelLayers for each pixel, row 0 on top. Reuses a buffer of the right size: many views share one.
Result<void> findLayers(const std::shared_ptr<gpu::Device>& device, const SceneView& scene,
                        const gpu::Kernel& kernel, int width, int height, std::optional<gpu::Buffer>& layers);

}  // namespace macula::trace
