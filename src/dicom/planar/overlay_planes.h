// Overlays of an image: marks of one bit for each pixel, in elements of their own or in bits of the pixels
// that hold no value (PS3.3 C.9.2; the latter as in its edition of 2004).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dicom/read/dataset.h"

namespace macula::dicom {

struct OverlayPlane {
    int group = 0x6000;  // to 0x601E
    int columns = 0;     // at least 1, as rows
    int rows = 0;
    // Where its first pixel lies in the image, (column, row) from 1; may lie outside.
    glm::ivec2 origin{1};
    int firstFrame = 1;         // of the image, from 1, over which its first frame lies
    std::optional<int> frames;  // nothing: the one plane lies over all frames of the image
    bool isRegion = false;      // it marks a region of interest, not graphics
    std::string label;          // may be empty
    std::string layer;          // of a presentation state that shows it; empty: of none
    int embeddedBit = 0;        // of the pixel cells; 0: `packed` holds it
    // Eight pixels in a byte, the first in the lowest bit, frame by frame; null if embedded, or if only a
    // layer is named.
    std::shared_ptr<const std::vector<std::uint8_t>> packed;
};

// What is on of one plane, over one frame.
struct OverlayMask {
    int group = 0x6000;
    int columns = 0;
    int rows = 0;
    glm::ivec2 origin{1};    // as OverlayPlane::origin
    std::vector<bool> isOn;  // row by row

    // Whether it marks that pixel of the image, from 0.
    bool marks(int column, int row) const;
};

// In the order of their groups. Planes whose data are too short for their size, and those larger than any
// image, are left out.
std::vector<OverlayPlane> readOverlayPlanes(const Dataset& header);

// Over frame `frame` of the image, from 0. Nothing where it has no plane there, or is embedded.
std::optional<OverlayMask> maskOf(const OverlayPlane& plane, int frame);

// Of an embedded plane: from the cells of the frame, row by row, as the file has them. An embedded plane is
// as large as its image, which is `columns` wide.
OverlayMask embeddedMaskOf(const OverlayPlane& plane, int columns, std::span<const std::uint16_t> cells);

}  // namespace macula::dicom
