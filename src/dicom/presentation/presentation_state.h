// Volume Rendering Volumetric Presentation State objects (PS3.3 A.80.2): how a series is rendered in 3D, for
// archives and other programs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "base/result.h"
#include "dicom/presentation/volume_presentation.h"
#include "dicom/write/new_object.h"

namespace macula::dicom {

// Explicit VR little endian. Each call makes a new series and instance. The file is written whole or not at
// all, in place of one that is there. Reading it gives the same presentation, to the last bit, if the centre
// and the width of the palette's interval fit the 16 characters of a Decimal String; otherwise the nearest
// such interval. Fails with usage for numbers that are not finite or out of range, tables of unequal length,
// text that is too long, and a missing image unless deidentified; with inputNotUsable when the image cannot
// be read or is another one; with outputNotWritable.
Result<void> writePresentationState(const std::filesystem::path& path, const VolumePresentation& presentation,
                                    const NewObject& object);

struct PresentationState {
    VolumePresentation presentation;
    // Messages about what the object has but a VolumePresentation cannot hold: key::kPresentationLeftOut etc.
    std::vector<Message> messages;
    bool hasForeignChanges = false;  // ignored Macula's own state: the rest changed or has messages
};

// Never throws. Fails with inputNotUsable when the file is not such an object, refers to no images, or lacks
// camera or colours; or with outOfMemory.
Result<PresentationState> readPresentationState(const std::filesystem::path& path);

// Whether the presentation, deidentified or not, refers to the series whose UID has the SHA-256
// `seriesDigest`, in lower-case hexadecimal digits.
bool isSeries(const PresentedSeries& series, std::string_view seriesDigest);

}  // namespace macula::dicom
