// Windows (PS3.3 C.11.2) that nobody gave.
#pragma once

#include "base/volume.h"

namespace macula {

// The first window of the series; when it names none, all of its values.
DisplayWindow seriesWindow(const Volume& volume);

// In units; black at the low end, white at the high one.
DisplayWindow windowOver(const ValueRange& range);

}  // namespace macula
