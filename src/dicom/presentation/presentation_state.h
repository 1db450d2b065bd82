// Volume Rendering Volumetric Presentation State objects (PS3.3 A.80.2): how a series is rendered in 3D, for
// archives and other programs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "base/result.h"
#include "dicom/presentation/volume_presentation.h"
#include "dicom/write/secondary_capture.h"

namespace macula::dicom {

struct PresentationOwner {
    // An image of the series that is shown: patient and study are taken from it. It must still be that
    // instance. Where deidentified it may be left out, and tells only which objects are of one patient
    // (pseudonyms.h).
    std::optional<SecondaryCapture::Source> image;
    // Nothing of patient and study is taken over. UIDs of series, frame of reference and images are replaced
    // by those that standInUid makes of them: only who has the series and the key of this installation, which
    // is made where there is none, can tell that it is meant (isSeries).
    bool isDeidentified = false;
    std::string seriesDescription = "3D views";  // at most 64 characters, ASCII; no patient data
    std::string softwareVersion = "0";           // as that; not empty
    int seriesNumber = 9100;                     // after those of scanners
};

// Explicit VR little endian. Each call makes a new series and instance. The file is written whole or not at
// all, in place of one that is there. Reading it gives the same presentation, to the last bit, where the
// middle and the width of the palette's interval fit the 16 characters of a Decimal String; else that
// interval is as near as these come. usage for numbers that are not finite or out of their range, tables of
// unequal length, text that is too long, and without an image where it is somebody's; inputNotUsable when the
// image cannot be read or is another one; outputNotWritable.
Result<void> writePresentationState(const std::filesystem::path& path, const VolumePresentation& presentation,
                                    const PresentationOwner& owner);

struct PresentationState {
    VolumePresentation presentation;
    // What the object has that a VolumePresentation cannot say, of the catalogue: key::kPresentationLeftOut
    // and so on.
    std::vector<Message> messages;
    bool hasForeignChanges = false;  // it has an own state of Macula that no longer fits the rest
};

// Throws nothing, whatever is in the file. inputNotUsable when it is no such object, refers to no images, or
// lacks what a picture cannot be made without: camera, colours.
Result<PresentationState> readPresentationState(const std::filesystem::path& path);

// Whether the series, of which `seriesDigest` is the SHA-256 of the UID in hexadecimal digits, is the one
// that the presentation is of, deidentified or not.
bool isSeries(const PresentedSeries& series, std::string_view seriesDigest);

}  // namespace macula::dicom
