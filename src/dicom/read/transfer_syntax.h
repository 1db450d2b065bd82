// The transfer syntaxes this build decodes (PS3.5 section 10, PS3.6 annex A). A table of our own: DCMTK's
// DcmXfer (3.6.7) knows neither High-Throughput JPEG 2000 nor JPEG XL, and calls lossy what may be either.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace macula::dicom {

enum class Codec { native, rle, jpeg, jpegLs, jpeg2000, unsupported };

struct TransferSyntaxInfo {
    Codec codec = Codec::unsupported;
    std::string_view name;  // "JPEG 2000"; empty when not known
};

TransferSyntaxInfo transferSyntaxInfo(std::string_view uid);

// For a person: "JPEG 2000 (1.2.840.10008.1.2.4.91)". Something that is no UID is not repeated.
std::string describeTransferSyntax(std::string_view uid);

// The bytes are the beginning of a stream of JPEG, JPEG-LS, JPEG 2000 or run lengths. Any number of bytes; 8
// are enough.
bool beginsStream(std::span<const unsigned char> bytes);

// The transfer syntax of a fragment that begins like this, where that cannot be the one that the file names:
// some archives change one without the other. Empty where it can, or where nothing is known of the bytes.
std::string_view syntaxInstead(std::string_view named, std::span<const unsigned char> fragment);

// The syntax itself is a lossy one. (One that may be either is told by LossyImageCompression.)
bool isLossy(std::string_view uid);

}  // namespace macula::dicom
