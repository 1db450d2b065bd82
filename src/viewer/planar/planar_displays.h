// The ways to show an image that its file offers.
#pragma once

#include <QString>
#include <vector>

#include "study/planar/planar_display.h"

namespace macula::viewer {

struct NamedDisplay {
    QString name;
    study::PlanarDisplay display;
};

// The tables of the file, its windows, and all values; each inverted as `now` is. None for colours.
std::vector<NamedDisplay> displaysOf(const dicom::Frame& frame, const dicom::PlanarHeader& header,
                                     const dicom::PlanarFrame& pixels, const study::PlanarDisplay& now);

// After a drag, in parts of the pane: wider to the right, brighter up.
study::PlanarDisplay draggedBy(double partX, double partY, const study::PlanarDisplay& display,
                               const dicom::PlanarHeader& header, const dicom::PlanarFrame& pixels);

}  // namespace macula::viewer
