// Views to learn from that need not be traced again: for those who train on the same ones once more, and,
// of views that are not lit by each other, for those who were stopped among hundreds of them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "pipeline/hybrid/views/picture_cache.h"
#include "pipeline/hybrid/views/traced_scene.h"
#include "pipeline/trace/settings.h"

namespace macula::hybrid {

// What a view is made of.
struct ViewMaking {
    trace::View view;
    trace::Settings settings;
    std::uint32_t samplesPerPixel = 0;  // 0: it is lit by what others have found
};

// The views of one scene, in a cache that may hold those of other scenes. `scene` and `cache` must outlive
// it.
class ViewCache {
  public:
    ViewCache(const TracedScene& scene, const PictureCache& cache) : scene_(scene), cache_(cache) {}

    // A view that was traced by itself. Nothing when it is not there. usage as makeTraceParams.
    Result<std::optional<TracedView>> find(const ViewMaking& making) const;
    // Writes the file whole or not at all. usage, outputNotWritable.
    Result<void> keep(const ViewMaking& making, const TracedView& view) const;

    // The same for a set of views that are lit by what all of them have found, and so belong to that set
    // only. In their order; nothing when one is not there.
    Result<std::optional<std::vector<TracedView>>> findSet(std::span<const ViewMaking> makings) const;
    Result<void> keepSet(std::span<const ViewMaking> makings, std::span<const TracedView> views) const;

  private:
    std::optional<TracedView> read(const std::string& key, const ViewMaking& making) const;
    Result<std::string> keyOf(const ViewMaking& making) const;
    Result<std::vector<std::string>> keysOf(std::span<const ViewMaking> makings) const;

    const TracedScene& scene_;
    const PictureCache& cache_;
};

}  // namespace macula::hybrid
