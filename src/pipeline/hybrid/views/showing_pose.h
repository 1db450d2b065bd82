// Which of the poses that would teach a model most shows anything.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/views/candidate_poses.h"
#include "pipeline/splat/model/splats.h"

namespace macula::hybrid {

// The first of `wanted` in which the model shows enough, or else the one in which it shows most; nothing when
// it shows nothing in any. Small pictures in the shape of `sizePx` are drawn, mostly one. Fails as drawViews.
Result<std::optional<CandidatePose>> firstThatShows(const std::shared_ptr<gpu::Device>& device,
                                                    const splat::Splats& model,
                                                    std::span<const CandidatePose> wanted,
                                                    const glm::ivec2& sizePx);

}  // namespace macula::hybrid
