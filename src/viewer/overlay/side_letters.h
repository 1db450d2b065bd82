// Letters of the patient's sides at the edges of a 3D picture.
#pragma once

#include <QSize>
#include <memory>

#include "live/frame/picture_text.h"
#include "scene/camera/orbit_camera.h"

namespace macula::viewer {

// Adds letters above `others`, for a picture of `pixels` device pixels on a screen of `pixelRatio`, placed as
// on slices: see placeSides. Returns `others`, which may be null, if no letter is known or fits. Needs a
// QGuiApplication.
std::shared_ptr<const live::PictureText> withSideLetters(
    const std::shared_ptr<const live::PictureText>& others, const scene::EdgeLetters& sides, QSize pixels,
    double pixelRatio);

}  // namespace macula::viewer
