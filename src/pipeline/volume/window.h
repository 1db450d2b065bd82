// Default windows (PS3.3 C.11.2), used until a person chooses one.
#pragma once

#include <optional>
#include <utility>

#include "base/volume.h"
#include "pipeline/volume/transfer_function.h"

namespace macula {

// The first window of the series, or one over all values if it names none. For activity, activityWindow.
DisplayWindow seriesWindow(const Volume& volume);

// Whether values come from emission tomography: Bq/mL, SUV, or any numbers of PET.
bool isActivity(const Volume& volume);

// From 0 to 10 SUV, or to the highest value if that is lower. For other activity up to the 99.9th percentile,
// because the bladder would leave everything else black. Ignores windows of the series: PET scanners write
// them over all values of a slice. Nothing if no value is above 0. Samples some hundred thousand values,
// except for SUV.
std::optional<DisplayWindow> activityWindow(const Volume& volume);

// For a maximum intensity projection: the first window of the series, unless it makes a third of the picture
// plain white, as one for soft tissue does in a chest. Then, or without a window, from the 10th to the 99th
// percentile of the maxima along the axes of the volume. For activity, seriesWindow. The volume must be
// stored16.
DisplayWindow maximumWindow(const Volume& volume);

// The effective range of the preset, fitted to the volume like the preset; nothing if it has none.
std::optional<DisplayWindow> presetWindow(const TransferFunction& preset, const Volume& volume);

// Black and white of a window, as positions in the tables of entries (entry_map.h). By PS3.3 C.11.2.1.2,
// LINEAR reaches white one unit before the end of the window. A SIGMOID is drawn as a line over its centre
// and width.
std::pair<float, float> entriesOf(const DisplayWindow& window, const Volume& volume);

// The window that is black at the low end of a range and white at its high end.
DisplayWindow windowOver(const ValueRange& range);

}  // namespace macula
