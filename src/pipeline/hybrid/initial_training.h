// From the model of points to one that has learnt from a few traced views.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/traced_view.h"
#include "pipeline/splat/splats.h"

namespace macula::hybrid {

// `steps` steps of splat::Trainer with its stages, drawn out or together to that many; pictures are compared
// as they are displayed. `radiusMm` is half the diagonal of what is seen. Fails with usage without views,
// where the trainer does, and with `cancelled` when `keepGoing` (may be empty) says no. No step is no change.
Result<splat::Splats> trainInitial(const std::shared_ptr<gpu::Device>& device, const splat::Splats& first,
                                   std::span<const TracedView> views, double radiusMm, std::uint64_t steps,
                                   const std::function<bool()>& keepGoing = {});

}  // namespace macula::hybrid
