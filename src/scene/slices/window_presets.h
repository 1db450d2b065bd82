// Windows that a person selects by a digit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/volume.h"

namespace macula::scene {

struct WindowPreset {
    int digit = 0;  // 1 to 9
    std::string name;
    std::optional<DisplayWindow> window = {};  // nothing: that of the series, as in SliceState
};

// Sorted by digit; 1 is the window of the series (seriesWindow), 9 all values. Those between are customary
// windows for CT in HU and PET in SUV; otherwise the further windows of the series, or all of them for PET in
// other units, whose digit 1 is none of them.
std::vector<WindowPreset> windowPresets(const Volume& volume);

// Nothing where the volume has none with that digit.
std::optional<WindowPreset> windowPreset(const Volume& volume, int digit);

}  // namespace macula::scene
