// What texts and marks cover of a picture.
#pragma once

#include <QRect>

#include "live/frame/picture_text.h"

namespace macula::viewer::test {

inline QRect coveredBy(const live::PictureText& text) {
    QRect all;
    for (std::size_t i = 0; i < text.boxes.size(); ++i) {
        const VkRect2D& box = text.boxes[i];
        const VkOffset2D at = text.places.empty() ? box.offset : text.places[i];
        all |= QRect(at.x, at.y, int(box.extent.width), int(box.extent.height));
    }
    return all;
}

}  // namespace macula::viewer::test
