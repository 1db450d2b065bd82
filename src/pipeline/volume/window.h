// Default windows (PS3.3 C.11.2), for when nobody chose one.
#pragma once

#include <optional>
#include <utility>

#include "base/volume.h"
#include "pipeline/volume/transfer_function.h"

namespace macula {

// The first window of the series; when it names none, all of its values. Of activity activityWindow.
DisplayWindow seriesWindow(const Volume& volume);

// Whether values are those of emission tomography: Bq/mL, SUV, or any numbers of PET.
bool isActivity(const Volume& volume);

// From 0 to 10 SUV, or to the highest value below that. Of other activity up to what all but a thousandth of
// the values stay below, because the bladder would leave everything else black; PET scanners name windows
// over all of a slice. Nothing where no value is above 0. Looks at some hundred thousand values, but for SUV.
std::optional<DisplayWindow> activityWindow(const Volume& volume);

// For a projection of largest values: the first window of the series, unless that makes a third of the
// picture plain white, as one for soft tissue does in a chest; then, or when there is none, from the tenth to
// the highest hundredth of the largest values along the axes of the volume. The volume must be stored16.
DisplayWindow maximumWindow(const Volume& volume);

// The effective range of the preset, fitted to the volume as the preset is; nothing when it names none.
std::optional<DisplayWindow> presetWindow(const TransferFunction& preset, const Volume& volume);

// Black and white of a window, as positions in the tables of entries (entry_map.h). PS3.3 C.11.2.1.2: LINEAR
// is white one unit before the end of the window. A SIGMOID is drawn as the line that its centre and width
// tell.
std::pair<float, float> entriesOf(const DisplayWindow& window, const Volume& volume);

// The window in units that is black at the low end of a range and white at its high end.
DisplayWindow windowOver(const ValueRange& range);

}  // namespace macula
