// Explains an empty picture.
#pragma once

#include <QString>

#include "base/volume.h"
#include "scene/choice/catalogue.h"
#include "scene/drawing/drawing.h"

namespace macula::viewer {

// Says why the drawing shows nothing of the volume, or why a projection is all black or white: which values
// the volume has, and which presets would show something. Empty if something is visible; ignores the clip.
QString visibilityNote(const scene::Drawing& drawing, const Volume& volume,
                       const scene::Catalogue& catalogue);

}  // namespace macula::viewer
