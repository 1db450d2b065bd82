// Views that a model has asked for, and that have not arrived yet.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "base/camera.h"
#include "pipeline/hybrid/views/training_views.h"
#include "pipeline/splat/draw/raster_view.h"

namespace macula::hybrid {

class AskedViews {
  public:
    explicit AskedViews(const glm::ivec2& sizePx) : sizePx_(sizePx) {}

    // Keeps the last few.
    void add(const Camera& camera);
    // Call when a picture has arrived from `from`: forgets views of the same pose.
    void came(const splat::RasterView& from, const glm::dvec3& originMm, double radiusMm,
              const AdmissionOptions& options);
    // The views, with pictures of `sizePx`, relative to the origin of a model.
    std::vector<splat::RasterView> views(const glm::dvec3& originMm) const;

  private:
    glm::ivec2 sizePx_;
    std::vector<Camera> cameras_;
};

}  // namespace macula::hybrid
