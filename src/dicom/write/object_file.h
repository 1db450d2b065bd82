// Begins and ends the writing of a DICOM object. Only for its writers.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "base/installation_key.h"
#include "base/result.h"
#include "dicom/read/values.h"
#include "dicom/write/item_writer.h"
#include "dicom/write/new_object.h"
#include "dicom/write/referenced_series.h"

class DcmFileFormat;  // of DCMTK

namespace macula::dicom {

constexpr std::size_t kLongestText = 64;  // characters, VR LO

// The series that a writer makes.
struct ObjectKind {
    std::string_view modality;
    std::string_view sopClassUid;
    int seriesNumber = 9100;  // after those of scanners
    std::string_view seriesDescription;
    bool needsUtf8 = false;  // texts that `fill` writes
};

// Fails with usage for a version that does not fit, and a missing image unless deidentified; `instead` says
// what to do then.
Result<void> checkOwner(const NewObject& object, Text instead);
Error refusedObject(Text message, Text hint);
Error textRefused();

// Writes patient, study, series, equipment and instance, lets `fill` write the rest, and saves the file:
// explicit VR little endian, whole or not at all, in place of one that is there. `standIns` is the key of a
// deidentified object. Fails with inputNotUsable when the image cannot be read or is another one, with
// outputNotWritable, and as `fill` does.
using Fill = std::function<void(ItemWriter to, const InstallationKey* standIns)>;
Result<void> writeObject(const std::filesystem::path& path, const NewObject& object, const ObjectKind& kind,
                         const Fill& fill);

// Explicit VR little endian, whole or not at all. Fails with outputNotWritable.
Result<void> saveObject(const std::filesystem::path& path, DcmFileFormat& format);

// Whether a text needs another character set than the default one (PS3.5 6.1.2).
bool isAscii(std::string_view text);
// Printable ASCII without a backslash, for VR LO.
bool isPlain(std::string_view text);
bool isCodeString(std::string_view text);  // VR CS, not empty
bool areUids(const std::vector<ReferencedImage>& images);

}  // namespace macula::dicom
