// Text that stands in a corner of the picture, painted by Qt.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/frame/picture_text.h"

namespace macula::viewer {

// For a picture `widthPx` device pixels wide on a screen of `pixelRatio`; what is longer ends in an ellipsis.
// Null when there is nothing to say. Needs a QGuiApplication.
std::shared_ptr<const app::PictureText> paintText(const std::vector<std::string>& lines, int widthPx,
                                                  double pixelRatio);

}  // namespace macula::viewer
