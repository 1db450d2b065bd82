// An empty picture, explained.
#pragma once

#include <QString>

#include "base/volume.h"
#include "scene/choice/catalogue.h"
#include "scene/drawing/drawing.h"

namespace macula::viewer {

// Why nothing of the volume, or no difference in it, can be seen as it is drawn: which values it has, and
// which presets would show something. Empty where something can be seen, whatever a clip leaves of it.
QString visibilityNote(const app::Drawing& drawing, const Volume& volume, const app::Catalogue& catalogue);

}  // namespace macula::viewer
