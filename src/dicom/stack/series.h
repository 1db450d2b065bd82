// A series: all objects with one SeriesInstanceUID in one patient's study.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/text.h"
#include "dicom/read/referenced_frames.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

// The heading of a presentation state, as in the file, and the images that it refers to.
struct PresentationHeading {
    std::string label;
    std::string description;
    std::string date;                      // YYYYMMDD
    std::string time;                      // HHMMSS
    std::string creator;                   // components separated by ^
    std::vector<ReferencedFrames> images;  // as byImage

    bool operator==(const PresentationHeading&) const = default;
};

// A DICOM object that is not an image: a report, a structure set, a segmentation, a presentation state.
struct OtherObject {
    std::filesystem::path file;
    std::string sopClassUid;
    Text kind;                                      // "Segmentation"; for a person
    std::vector<std::string> referencedSeriesUids;  // of a segmentation or presentation state; sorted
    std::string label;  // of a presentation state its description or label, of a document its title
    std::optional<PresentationHeading> presentation = {};  // of a presentation state of any kind
};

// Descriptions, numbers and UIDs may name a patient: for the screen, never for the log.
struct Series {
    std::string studyInstanceUid;
    std::string seriesInstanceUid;
    std::string modality;
    std::string description;
    std::optional<int> number;
    std::string
        patientPosition;  // "HFS" …; for the reader only, geometry never depends on it (PS3.3 C.7.3.1.1.2)

    // The stacks of its images: none, one, or several when they differ in attributes of the split rules. No
    // stack is empty.
    std::vector<Stack> stacks;
    std::vector<OtherObject> objects;
    std::vector<std::string> transferSyntaxUids;  // of the images; distinct, sorted
    std::size_t instances = 0;                    // image files in the stacks
    std::size_t filesLeftOut = 0;                 // unreadable files of the series
    bool scattered = false;                       // has an image that key::kUidPerSlice asks about

    std::vector<Message> messages;  // about the series as a whole; each stack has its own
    std::vector<Text> assumptions;  // hold for each of its stacks

    // Whether one of its stacks can be shown in 3D.
    bool canBeVolume() const;
};

}  // namespace macula::dicom
