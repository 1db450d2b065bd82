// Copies to images of the headset that are not of a whole picture, or not of colours.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"
#include "xr/visibility_mask.h"

namespace macula::xr {

// Of the part of a picture that begins at `firstPx`, those parts; the rest of the layer becomes black and
// clear. Bit by bit.
void copyVisible(gpu::Recorder& recorder, const gpu::Image& from, const glm::ivec2& firstPx,
                 std::span<const VisiblePart> parts, const gpu::LentLayer& to);

// The part of `partPx` at `firstPx` of depths in rows of `rowPx`, to the depths of a layer (D32_SFLOAT).
// The device's queue draws (drawsOnQueue).
void copyDepths(gpu::Recorder& recorder, const gpu::Buffer& from, int rowPx, const glm::ivec2& firstPx,
                const glm::ivec2& partPx, const gpu::LentLayer& to);

// Whether the device's queue can do more than compute: depths cannot be copied on another.
bool drawsOnQueue(const gpu::Device& device);

}  // namespace macula::xr
