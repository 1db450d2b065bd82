// Display shutters (PS3.3 C.7.6.11): what of an image is not to be seen.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "dicom/read/dataset.h"

namespace macula::dicom {

// Of several shapes only what all of them show is seen. Columns and rows count from 1; edges are seen.
struct DisplayShutter {
    struct Rectangle {
        int left = 1;
        int right = 1;
        int top = 1;
        int bottom = 1;
    };
    struct Circle {
        glm::ivec2 centre{1};  // (column, row)
        int radius = 0;        // in columns; as round on the screen as pixels are high
    };
    std::optional<Rectangle> rectangle;
    std::optional<Circle> circle;
    std::vector<glm::ivec2> polygon;  // vertices (column, row); none, or at least 3
    std::uint8_t grey = 0;            // of what is hidden
};

// Nothing where there is none; shapes that make no sense are left out. A shutter that would hide all of the
// image is returned as it is.
std::optional<DisplayShutter> readDisplayShutter(const Dataset& header);

// Whether each pixel of an image is hidden, row by row. `heightOverWidth` of a pixel.
std::vector<bool> hiddenBy(const DisplayShutter& shutter, int columns, int rows, double heightOverWidth);

}  // namespace macula::dicom
