// Letters of the patient's sides at the edges of a 3D picture.
#pragma once

#include <QSize>
#include <memory>

#include "live/frame/picture_text.h"
#include "scene/camera/orbit_camera.h"

namespace macula::viewer {

// With letters above what else is of a picture of so many device pixels on a screen of `pixelRatio`, where
// slices have theirs: see placeSides. `others` itself, which may be null, where none has room or none is
// told. Needs a QGuiApplication.
std::shared_ptr<const app::PictureText> withSideLetters(const std::shared_ptr<const app::PictureText>& others,
                                                        const app::EdgeLetters& sides, QSize pixels,
                                                        double pixelRatio);

}  // namespace macula::viewer
