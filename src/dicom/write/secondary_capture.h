// Writes a picture for the archive: a Secondary Capture Image (PS3.3 A.8.1) in the study that it shows.
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
    std::span<const std::uint8_t> rgba;  // 4 bytes per pixel, top row first; the fourth is ignored
    // An image of the series shown, which gives patient, study and modality, with the character sets. It must
    // still be that instance: the path may lead to another disc by now.
    struct Source {
        std::filesystem::path file;
        std::string sopInstanceUid;
    };
    std::optional<Source> source;
    bool isOfNobody = false;        // made up by a program; then it has no source
    std::string seriesDescription;  // at most 64 characters, ASCII, as the next two; no patient data
    std::string derivation;         // how it was made, in words; at most 1024 characters
    std::string softwareVersion;
    int seriesNumber = 9000;  // after those of scanners
    // Copies nothing of patient and study, and makes all UIDs new. The source, if there is one, only shows
    // which objects belong to one patient and one study: they share random IDs (object_owner.h). Visible
    // features, such as a face, stay.
    bool isDeidentified = false;
    // The length of the patient shown along the body, if known; decides whether the file says that a face may
    // be visible (object_owner.h).
    std::optional<double> heightMm;
    bool hasBurnedInNames = false;  // the picture shows the patient's name
};

// Explicit VR little endian, RGB, 8 bits. Each call makes a new series and instance. The file is written
// whole or not at all, in place of one that is there. Fails with usage for sizes and texts that do not fit,
// and for a missing source unless deidentified or of nobody; with inputNotUsable when the source cannot be
// read, is another one, or has no study; with outputNotWritable.
Result<void> writeSecondaryCapture(const std::filesystem::path& path, const SecondaryCapture& capture);

}  // namespace macula::dicom
