// A series: the images of one acquisition or reconstruction, sorted, with what can be said about them before
// any pixel is read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dicom/instance.h"
#include "dicom/messages.h"

namespace macula::dicom {

// Descriptions, numbers and UIDs may name a patient: for the screen, never for the log.
struct Series {
    std::string studyInstanceUid;
    std::string seriesInstanceUid;
    std::string modality;
    std::string description;
    std::optional<int> number;
    std::string
        patientPosition;  // "HFS" …; for the reader only, geometry never depends on it (PS3.3 C.7.3.1.1.2)

    // Ascending along the slice normal when they have positions, else by instance number.
    std::vector<Instance> instances;
    std::vector<std::string> transferSyntaxUids;  // distinct, sorted

    int columns = 0;  // of the first instance
    int rows = 0;
    int slices = 0;                       // instances times frames
    std::optional<glm::dvec3> spacingMm;  // between columns, rows, slices; known when it is a volume
    std::string orientation;              // where columns, rows, slices run to, e.g. "LPS"; may be empty
    std::optional<glm::dvec3> firstPositionMm;  // patient LPS
    std::optional<glm::dvec3> lastPositionMm;
    std::optional<glm::dmat4>
        worldFromVoxel;  // voxel (column, row, slice) to patient LPS mm; set when it is a volume

    std::vector<Message> messages;
    std::vector<std::string> assumptions;  // for the volume's provenance

    bool canBeVolume() const;
    // The first message that blocks; null when none does.
    const Message* whyNoVolume() const;
};

// Sorts the instances, and fills in everything that follows from them. Keeps messages that are there already.
void assess(Series& series);

// A localizer (scout, topogram) in any of its images: ImageType value 3, PS3.3 C.8.2.1.1.1.
bool isLocalizer(const Series& series);
// ORIGINAL\PRIMARY in all of its images: PS3.3 C.7.6.1.1.2.
bool isOriginalPrimary(const Series& series);

}  // namespace macula::dicom
