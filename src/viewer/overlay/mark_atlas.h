// The pixels of what stands over a 3D picture, put together.
#pragma once

#include <QImage>
#include <QSize>
#include <memory>
#include <vector>

#include "live/frame/picture_text.h"

namespace macula::viewer {

// What is painted on something transparent, as boxes that cover it and little more: runs of rows, and runs
// that go on in the next row together. Gaps of up to `closePx` between runs count as painted.
std::vector<VkRect2D> coveredBoxes(const QImage& painted, int closePx);
// The same pixels, opaque on something dark, as RGBA.
QImage opaque(const QImage& painted);

// Images one below the other; each is a box of its own, or several.
class MarkAtlas {
  public:
    // Goes on with those of `others`, which may be null, for a picture of so many device pixels; of 0 x 0:
    // for any.
    MarkAtlas(const std::shared_ptr<const app::PictureText>& others, QSize pixels);

    VkRect2D add(const QImage& image);  // its box; QImage::Format_RGBA8888
    void place(const VkRect2D& box, VkOffset2D at);
    // Only what is painted covers the picture.
    void placeShape(const QImage& painted, VkOffset2D at, int closePx);

    std::shared_ptr<const app::PictureText> take();

  private:
    void widen(std::uint32_t width);

    app::PictureText atlas_;
};

}  // namespace macula::viewer
