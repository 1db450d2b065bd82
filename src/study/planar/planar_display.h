// How an image is shown: by a window or a table of the file, or as a person sets it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/volume.h"
#include "dicom/planar/planar_frame.h"
#include "dicom/planar/planar_header.h"
#include "dicom/stack/instance.h"

namespace macula::study {

struct PlanarDisplay {
    DisplayWindow window;
    std::optional<std::size_t> table;                  // of PlanarHeader::tables, instead of the window
    bool isInverted = false;                           // beyond what the file says
    std::shared_ptr<const dicom::VoiTable> presented;  // of a presentation state, instead of both

    bool operator==(const PlanarDisplay&) const = default;
};

// The file's first table, else its first window, else the range of the frame's values, for which the middle
// 98 of 100 count.
PlanarDisplay usualDisplay(const dicom::Frame& frame, const dicom::PlanarHeader& header,
                           const dicom::PlanarFrame& pixels);

// Linear, from the lowest to the highest value.
DisplayWindow wholeRange(const dicom::PlanarFrame& pixels);

// Row by row from the first one. Grey: one byte for each pixel, black where there is no value; colour: three,
// which no window changes.
struct PlanarPicture {
    int columns = 0;
    int rows = 0;
    bool isColour = false;
    std::vector<std::uint8_t> bytes;
};
PlanarPicture pictureOf(const dicom::PlanarFrame& pixels, const dicom::PlanarHeader& header,
                        const PlanarDisplay& display);

// Turned clockwise by quarters, and then perhaps mirrored.
PlanarPicture turned(PlanarPicture picture, int quarters, bool isMirrored);

// Paints what the shutter hides in its grey. `heightOverWidth` of a pixel.
void addShutter(PlanarPicture& picture, const dicom::DisplayShutter& shutter, double heightOverWidth);
// Paints what an overlay marks white, within the picture.
void addOverlay(PlanarPicture& picture, const dicom::OverlayMask& overlay);

}  // namespace macula::study
