// Text over the 3D picture, painted by Qt: in a corner, and letters of the patient's sides at the edges.
#pragma once

#include <QSize>
#include <memory>
#include <string>
#include <vector>

#include "live/frame/picture_text.h"
#include "scene/camera/orbit_camera.h"

namespace macula::viewer {

struct LinesOver {
    std::vector<std::string> names = {};  // patient and study, the least important last
    std::vector<std::string> notes = {};  // warnings about the picture

    bool operator==(const LinesOver&) const = default;
};

// For a picture of `pixels` device pixels on a screen of `pixelRatio`. Letters have a dark rim on a
// transparent ground. A long name is elided in the middle; a long note wraps. A low picture omits the last
// names, but never the first name or a note. Null without text, or without room for a letter. Needs a
// QGuiApplication.
std::shared_ptr<const live::PictureText> paintText(const LinesOver& lines, QSize pixels, double pixelRatio);

// Adds letters above `others`, for a picture of `pixels` device pixels on a screen of `pixelRatio`, placed as
// on slices: see placeSides. Returns `others`, which may be null, if no letter is known or fits. Needs a
// QGuiApplication.
std::shared_ptr<const live::PictureText> withSideLetters(
    const std::shared_ptr<const live::PictureText>& others, const scene::EdgeLetters& sides, QSize pixels,
    double pixelRatio);

}  // namespace macula::viewer
