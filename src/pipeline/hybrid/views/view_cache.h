// Keeps training views, so that another training on the same ones need not trace them again, and a cancelled
// one (of views that do not light each other) can continue.
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

// What determines a view's picture.
struct ViewMaking {
    trace::View view;
    trace::Settings settings;
    std::uint32_t samplesPerPixel = 0;  // 0: lit by the light of other views
};

// The views of one scene, in a cache that may hold those of other scenes. `scene` and `cache` must outlive
// this object.
class ViewCache {
  public:
    ViewCache(const TracedScene& scene, const PictureCache& cache) : scene_(scene), cache_(cache) {}

    // Finds a view that was traced without light from others; nothing if it is missing. Fails with usage as
    // makeTraceParams does.
    Result<std::optional<TracedView>> find(const ViewMaking& making) const;
    // Writes the file whole or not at all. Fails with usage, likewise, and outputNotWritable.
    Result<void> keep(const ViewMaking& making, const TracedView& view) const;

    // The same for a set of views that light each other, and so belong only to that set. In their order;
    // nothing if one is missing.
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
