// Finds a pose that shows something among those that would teach a model most.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/views/candidate_poses.h"
#include "pipeline/splat/model/splats.h"

namespace macula::hybrid {

// The first of `wanted` in which the model covers enough of the picture, or else the one in which it covers
// most; nothing if all are empty. Draws small pictures in the shape of `sizePx`, usually one. Fails as
// drawViews does.
Result<std::optional<CandidatePose>> firstThatShows(const std::shared_ptr<gpu::Device>& device,
                                                    const splat::Splats& model,
                                                    std::span<const CandidatePose> wanted,
                                                    const glm::ivec2& sizePx);

}  // namespace macula::hybrid
