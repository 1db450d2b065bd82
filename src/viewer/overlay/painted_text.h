// Text that stands in a corner of the 3D picture, painted by Qt.
#pragma once

#include <QSize>
#include <memory>
#include <string>
#include <vector>

#include "live/frame/picture_text.h"

namespace macula::viewer {

struct LinesOver {
    std::vector<std::string> names = {};  // whose picture it is; what matters least comes last
    std::vector<std::string> notes = {};  // what has to be known of it

    bool operator==(const LinesOver&) const = default;
};

// For a picture of so many device pixels on a screen of `pixelRatio`. Letters have a dark rim, and the
// picture is seen between them. A name that is too long is cut in its middle; a note goes on in the next
// line. In a low picture the last names go, but never the first one, nor a note. Null when there is nothing
// to say, or no room for a letter. Needs a QGuiApplication.
std::shared_ptr<const app::PictureText> paintText(const LinesOver& lines, QSize pixels, double pixelRatio);

}  // namespace macula::viewer
