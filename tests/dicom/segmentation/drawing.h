// Segmentation objects byte by byte.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/frames.h"
#include "bytes.h"

namespace macula::dicom::test {

// A segmentation object of which everything can be wrong.
struct Drawing {
    struct Frame {
        glm::dvec3 positionMm{0.0};
        int segment = 1;
    };
    std::string type = "BINARY";
    std::string sopClass = "1.2.840.10008.5.1.4.1.1.66.4";
    std::string transferSyntax = kExplicit;
    int columns = 5;
    int rows = 3;
    int bits = 1;
    std::string orientation = "1\\0\\0\\0\\1\\0";
    std::string pixelSpacing = "0.5\\0.25";  // between rows, between columns
    std::string sliceSpacing = "2";
    std::vector<Frame> frames;
    std::string claimedFrames;  // when not as many as there are
    std::vector<int> segments{1, 2};
    std::map<int, std::string> labels;  // else "label 1"
    std::set<int> codedBackground;      // by Segmented Property Type
    std::string padding;                // elements of group 28 after High Bit
    std::string more;                   // elements of the top level, from group 62 on
    std::string pixels;                 // packed
};

// Two bytes, little endian.
std::string word(int value);

std::string bytesOfDrawing(const Drawing& drawing);

}  // namespace macula::dicom::test
