#include "dicom/stack/series.h"

#include <algorithm>

namespace macula::dicom {

bool Series::canBeVolume() const {
    const bool blocked = std::any_of(messages.begin(), messages.end(),
                                     [](const Message& m) { return m.severity >= Severity::blocksVolume; });
    return !blocked &&
           std::any_of(stacks.begin(), stacks.end(), [](const Stack& s) { return s.canBeVolume(); });
}

}  // namespace macula::dicom
