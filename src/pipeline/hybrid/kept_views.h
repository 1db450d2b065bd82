// Views to learn from that need not be traced again: for those who train on the same ones once more, or who
// were stopped among hundreds of them.
#pragma once

#include <cstdint>
#include <optional>

#include "base/result.h"
#include "pipeline/hybrid/picture_cache.h"
#include "pipeline/hybrid/traced_scene.h"
#include "pipeline/hybrid/traced_view.h"
#include "pipeline/trace/settings.h"

namespace macula::hybrid {

// Of one scene, in a cache that may hold those of others. `scene` and `cache` must outlive it.
class KeptViews {
  public:
    KeptViews(const TracedScene& scene, const PictureCache& cache) : scene_(scene), cache_(cache) {}

    // Nothing when it is not there. usage as makeTraceParams.
    Result<std::optional<TracedView>> find(const trace::View& view, const trace::Settings& settings,
                                           std::uint32_t samplesPerPixel) const;
    // Whole or not at all. usage, outputNotWritable.
    Result<void> keep(const trace::View& view, const trace::Settings& settings, std::uint32_t samplesPerPixel,
                      const TracedView& traced) const;

  private:
    const TracedScene& scene_;
    const PictureCache& cache_;
};

}  // namespace macula::hybrid
