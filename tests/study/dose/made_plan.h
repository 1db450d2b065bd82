// A treatment plan of which every dose is known.
#pragma once

#include <filesystem>
#include <string>

namespace macula::study::test {

struct MadePlan {
    std::string frameOfReferenceUid = "2.25.1002";  // of the dose; the images have this one
    std::string units = "GY";
    std::string summation = "PLAN";
    std::string prescriptions = "40";  // of targets, with backslashes between; empty: no plan
    bool absoluteOffsets = false;      // GridFrameOffsetVector holds z
};

// Images: 20 x 20 x 10 voxels of 2 mm, the first at (-20, -20, -10). Dose: 12 x 12 x 8 points of 4 mm, the
// first at (-24, -24, -14); at x it is x + 24 Gy, at most 44. A region "BOX" holds the voxels from -8 to 8 mm
// in x and y and from -4 to 4 in z, of 16 to 32 Gy; "SIDE" those of x from 16 to 18; "EMPTY" has none.
void writePlan(const std::filesystem::path& folder, const MadePlan& plan = {});

}  // namespace macula::study::test
