// Windows (PS3.3 C.11.2) that nobody gave.
#pragma once

#include <optional>

#include "base/volume.h"
#include "pipeline/volume/transfer_function.h"

namespace macula {

// The first window of the series; when it names none, all of its values.
DisplayWindow seriesWindow(const Volume& volume);

// The effective range of the preset, fitted to the volume as the preset is; nothing when it names none.
std::optional<DisplayWindow> presetWindow(const TransferFunction& preset, const Volume& volume);

// In units; black at the low end, white at the high one.
DisplayWindow windowOver(const ValueRange& range);

}  // namespace macula
