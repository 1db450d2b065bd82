// An empty picture, explained.
#pragma once

#include <QString>

#include "base/volume.h"
#include "viewer/catalogue.h"
#include "viewer/frame_input.h"

namespace macula::viewer {

// Why nothing of the volume, or no difference in it, can be seen as it is drawn: which values it has, and
// which presets would show something. Empty where something can be seen, whatever a clip leaves of it.
QString visibilityNote(const Drawing& drawing, const Volume& volume, const Catalogue& catalogue);

}  // namespace macula::viewer
