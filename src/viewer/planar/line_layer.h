// The line of one image on another: where the slice of the box that is chosen lies.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "viewer/planar/planar_layer.h"

namespace macula::viewer {

class LineLayer : public PlanarLayer {
  public:
    // Corners in pixels of the image, as study::outlineOn; nothing: no line.
    void show(const std::optional<std::array<glm::dvec2, 4>>& outline) { outline_ = outline; }
    void hide() { outline_.reset(); }
    bool isEmpty() const { return !outline_; }

    void paint(QPainter& painter, const QTransform& paneFromPicture, const QRectF& area) override;

  private:
    std::optional<std::array<glm::dvec2, 4>> outline_;
};

}  // namespace macula::viewer
