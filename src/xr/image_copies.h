// Copies to the headset's images that are not of a whole picture, or not of colours.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"
#include "xr/visibility_mask.h"

namespace macula::xr {

// Copies `parts` of the picture whose upper left corner is at `firstPx`, bit by bit; the rest of the layer
// becomes black and transparent.
void copyVisible(gpu::Recorder& recorder, const gpu::Image& from, const glm::ivec2& firstPx,
                 std::span<const VisiblePart> parts, const gpu::LentLayer& to);

// Copies the part of size `partPx` at `firstPx`, from depths in rows of `rowPx`, to a depth layer
// (D32_SFLOAT). The device's queue must be a graphics queue (drawsOnQueue).
void copyDepths(gpu::Recorder& recorder, const gpu::Buffer& from, int rowPx, const glm::ivec2& firstPx,
                const glm::ivec2& partPx, const gpu::LentLayer& to);

// Whether the device's queue is a graphics queue, which copying of depths needs.
bool drawsOnQueue(const gpu::Device& device);

}  // namespace macula::xr
