#include "dicom/write/visible_face.h"

#include <algorithm>
#include <array>
#include <string>

namespace macula::dicom {

namespace {

// From the diaphragm to the feet (PS3.16 L). Without hands and arms, which are held over the head, and
// without the chest, whose uppermost slices may show the chin.
constexpr std::array<std::string_view, 26> kBelowTheChest{
    "ABDOMEN", "ABDOMENPELVIS", "ANKLE",  "BLADDER", "CALF",     "COCCYX", "COLON",    "FOOT",   "HIP",
    "KIDNEY",  "KNEE",          "LEG",    "LIVER",   "LOWERLEG", "LSPINE", "PANCREAS", "PELVIS", "PROSTATE",
    "RECTUM",  "SACRUM",        "SPLEEN", "SSPINE",  "THIGH",    "TOE",    "UPPERLEG", "UTERUS"};

constexpr double kHighestMm = 600.0;  // a tall patient from the diaphragm to the thigh

}  // namespace

bool mayShowFace(std::string_view bodyPart, std::optional<double> heightMm) {
    std::string part;
    for (const char c : bodyPart) {
        if (c >= 'a' && c <= 'z') part += char(c - 'a' + 'A');
        if (c >= 'A' && c <= 'Z') part += c;
    }
    const bool isBelow = std::ranges::find(kBelowTheChest, part) != kBelowTheChest.end();
    return !isBelow || !heightMm || !(*heightMm > 0.0 && *heightMm <= kHighestMm);
}

}  // namespace macula::dicom
