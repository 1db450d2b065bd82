// Windows that a person takes by a digit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/volume.h"

namespace macula::app {

struct WindowPreset {
    int digit = 0;  // 1 to 9
    std::string name;
    std::optional<DisplayWindow> window = {};  // nothing: that of the series, as in SliceState
};

// By ascending digits; 1 is the window of the series (seriesWindow), 9 all values. Of CT in HU and of PET in
// SUV the customary ones stand between them, of anything else further windows of the series; of other PET all
// of these.
std::vector<WindowPreset> windowPresets(const Volume& volume);

// Nothing where the volume has none with that digit.
std::optional<WindowPreset> windowPreset(const Volume& volume, int digit);

}  // namespace macula::app
