// A stack: frames that form a volume, or images that cannot, with the reason.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "dicom/messages/messages.h"
#include "dicom/stack/instance.h"

namespace macula::dicom {

// A value that distinguishes a stack from the others of its series.
struct StackLabel {
    std::string attribute;  // DICOM keyword, or "Repetition"
    std::string value;      // as in the images

    bool operator==(const StackLabel&) const = default;
};

struct Stack {
    std::string modality;             // of its images
    std::vector<StackLabel> splitBy;  // empty when the series is one stack
    int phase = 0;                    // number of `phases`, from 0, if positions were imaged several times
    int phases = 1;

    // Ascending along the slice normal when they have positions, otherwise by SliceLocation, otherwise by
    // number.
    std::vector<Frame> frames;
    std::vector<SliceSource> slices;  // slices of the volume, made from `frames`; empty when there is none

    int columns = 0;
    int rows = 0;
    std::optional<glm::dvec3> spacingMm;  // between columns, rows, slices; known when it is a volume
    bool isCalibrated = true;             // false: the size of a pixel is an estimate
    std::string orientation;              // directions of columns, rows, slices, e.g. "LPS"; may be empty
    std::optional<glm::dvec3> firstPositionMm;  // patient LPS
    std::optional<glm::dvec3> lastPositionMm;
    std::optional<glm::dmat4>
        worldFromVoxel;               // voxel (column, row, slice) to patient LPS mm; set when it is a volume
    std::optional<double> suvFactor;  // SUV (body weight) = factor * value; PET only

    std::vector<Message> messages;
    std::vector<Text> assumptions;  // for the volume's provenance

    bool canBeVolume() const;
    // The first message that blocks a volume; null when none does.
    const Message* whyNoVolume() const;
    bool isEven() const;  // a volume in which no slice is interpolated
};

// Adds a message to a stack or a series. Warnings are also assumptions, which stay with the volume wherever
// it goes.
template <class StackOrSeries>
void tell(StackOrSeries& to, Message message) {
    if (message.severity == Severity::warning) to.assumptions.push_back(message.sentence);
    to.messages.push_back(std::move(message));
}

// Sorts the frames, and fills in everything that follows from them. Keeps labels and existing messages.
// `modality` is that of the images.
void assess(Stack& stack, const std::string& modality);

// The position of each slice of a volume in patient LPS mm: that of its image, which may be slightly off the
// even grid; for interpolated slices that of the grid.
std::vector<glm::dvec3> slicePositionsMm(const Stack& stack);

// Whether any of its images is a localizer (scout, topogram): ImageType value 3, PS3.3 C.8.2.1.1.1.
bool isLocalizer(const Stack& stack);
// Whether ImageType is ORIGINAL\PRIMARY in all of its images: PS3.3 C.7.6.1.1.2.
bool isOriginalPrimary(const Stack& stack);

}  // namespace macula::dicom
