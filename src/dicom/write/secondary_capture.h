// A picture for the archive: a Secondary Capture Image (PS3.3 A.8.1) in the study that it was made of.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "base/result.h"

namespace macula::dicom {

struct SecondaryCapture {
    int widthPx = 0;  // 1 to 65535 each
    int heightPx = 0;
    std::span<const std::uint8_t> rgba;  // 4 bytes a pixel, the upper row first; the fourth is left out
    // An image of the series that is shown: patient, study and modality are taken from it, character sets and
    // all. It must still be that instance: what the path leads to may be another disc by now.
    struct Source {
        std::filesystem::path file;
        std::string sopInstanceUid;
    };
    std::optional<Source> source;
    bool isOfNobody = false;        // made up by a program: then there is no source
    std::string seriesDescription;  // at most 64 characters, ASCII, as the next two; no patient data
    std::string derivation;         // how it was made, in words, at most 1024
    std::string softwareVersion;
    int seriesNumber = 9000;  // after those of scanners
    // Nothing of the patient and of the study is taken over, and all UIDs are new. The source, where there is
    // one, tells only which objects are of one patient and one study: they share an ID that is made by chance
    // (pseudonyms.h). What can be seen, a face for one, stays.
    bool isDeidentified = false;
    // How much of the patient is shown along the body, where that is known: whether a face may be seen
    // (visible_face.h) is written.
    std::optional<double> heightMm;
    bool hasBurnedInNames = false;  // who is shown is written in the picture
};

// Explicit VR little endian, RGB, 8 bits. Each call makes a new series and instance. The file is written
// whole or not at all, in place of one that is there. usage for sizes and texts that do not fit, and without
// a source for a picture that is of somebody and not deidentified; inputNotUsable when the source cannot be
// read, is another one, or has no study; outputNotWritable.
Result<void> writeSecondaryCapture(const std::filesystem::path& path, const SecondaryCapture& capture);

}  // namespace macula::dicom
