// The transfer syntaxes this build decodes (PS3.5 section 10, PS3.6 annex A). Does not use DCMTK's DcmXfer
// (3.6.7), which knows neither High-Throughput JPEG 2000 nor JPEG XL, and calls lossy what may be either.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/text.h"

namespace macula::dicom {

enum class Codec { native, rle, jpeg, jpegLs, jpeg2000, unsupported };

struct TransferSyntaxInfo {
    Codec codec = Codec::unsupported;
    std::string_view name;  // "JPEG 2000"; empty when not known
};

TransferSyntaxInfo transferSyntaxInfo(std::string_view uid);

// For a person: "JPEG 2000 (1.2.840.10008.1.2.4.91)". Does not repeat text that is not a UID.
Text describeTransferSyntax(std::string_view uid);

// Whether the bytes begin a stream of JPEG, JPEG-LS, JPEG 2000 or run lengths. Takes any number of bytes; 8
// are enough.
bool beginsStream(std::span<const unsigned char> bytes);

// The transfer syntax of a fragment that begins with these bytes, if it cannot be the one that the file
// names: some archives change one without the other. Empty if it can, or if the bytes are unknown.
std::string_view syntaxInstead(std::string_view named, std::span<const unsigned char> fragment);

// Whether the syntax is always lossy. (For those that may be either, LossyImageCompression says it.)
bool isLossy(std::string_view uid);

}  // namespace macula::dicom
