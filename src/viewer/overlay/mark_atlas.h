// An atlas of the pixels drawn over a 3D picture.
#pragma once

#include <QImage>
#include <QSize>
#include <memory>
#include <vector>

#include "live/frame/picture_text.h"

namespace macula::viewer {

// Boxes that closely cover what is painted on a transparent image: the runs of each row, merged with equal
// runs of the next row. Gaps of up to `closePx` count as painted.
std::vector<VkRect2D> coveredBoxes(const QImage& painted, int closePx);
// The same pixels on an opaque dark ground, as RGBA.
QImage opaque(const QImage& painted);

// Images one below the other; each has one box or several.
class MarkAtlas {
  public:
    // Begins with the images of `others`, which may be null, for a picture of `pixels` device pixels; 0 x 0:
    // of any size.
    MarkAtlas(const std::shared_ptr<const live::PictureText>& others, QSize pixels);

    VkRect2D add(const QImage& image);  // returns its box; Format_RGBA8888
    void place(const VkRect2D& box, VkOffset2D at);
    // Covers the picture only where `painted` is not transparent.
    void placeShape(const QImage& painted, VkOffset2D at, int closePx);

    std::shared_ptr<const live::PictureText> take();

  private:
    void widen(std::uint32_t width);

    live::PictureText atlas_;
};

}  // namespace macula::viewer
