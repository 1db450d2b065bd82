#include "dicom/read/transfer_syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace macula::dicom {

namespace {

struct Row {
    std::string_view uid;
    TransferSyntaxInfo info;
};

constexpr std::array kTable = std::to_array<Row>({
    {"1.2.840.10008.1.2", {Codec::native, "Implicit VR Little Endian"}},
    {"1.2.840.10008.1.2.1", {Codec::native, "Explicit VR Little Endian"}},
    {"1.2.840.10008.1.2.1.98", {Codec::native, "Encapsulated Uncompressed Explicit VR Little Endian"}},
    {"1.2.840.10008.1.2.1.99", {Codec::native, "Deflated Explicit VR Little Endian"}},
    {"1.2.840.10008.1.2.2", {Codec::native, "Explicit VR Big Endian"}},
    {"1.2.840.10008.1.2.5", {Codec::rle, "RLE Lossless"}},
    {"1.2.840.10008.1.2.4.50", {Codec::jpeg, "JPEG Baseline"}},
    {"1.2.840.10008.1.2.4.51", {Codec::jpeg, "JPEG Extended"}},
    {"1.2.840.10008.1.2.4.53", {Codec::jpeg, "JPEG Spectral Selection"}},
    {"1.2.840.10008.1.2.4.55", {Codec::jpeg, "JPEG Full Progression"}},
    {"1.2.840.10008.1.2.4.57", {Codec::jpeg, "JPEG Lossless"}},
    {"1.2.840.10008.1.2.4.70", {Codec::jpeg, "JPEG Lossless, first-order prediction"}},
    {"1.2.840.10008.1.2.4.80", {Codec::jpegLs, "JPEG-LS Lossless"}},
    {"1.2.840.10008.1.2.4.81", {Codec::jpegLs, "JPEG-LS Near-lossless"}},
    {"1.2.840.10008.1.2.4.90", {Codec::jpeg2000, "JPEG 2000 Lossless"}},
    {"1.2.840.10008.1.2.4.91", {Codec::jpeg2000, "JPEG 2000"}},
    // These are known by name only, so that messages say more than a number.
    {"1.2.840.10008.1.2.4.92", {Codec::unsupported, "JPEG 2000 Multi-component Lossless"}},
    {"1.2.840.10008.1.2.4.93", {Codec::unsupported, "JPEG 2000 Multi-component"}},
    {"1.2.840.10008.1.2.4.100", {Codec::unsupported, "MPEG-2 video"}},
    {"1.2.840.10008.1.2.4.102", {Codec::unsupported, "MPEG-4 video"}},
    {"1.2.840.10008.1.2.4.110", {Codec::unsupported, "JPEG XL Lossless"}},
    {"1.2.840.10008.1.2.4.112", {Codec::unsupported, "JPEG XL"}},
    {"1.2.840.10008.1.2.4.201", {Codec::unsupported, "High-Throughput JPEG 2000 Lossless"}},
    {"1.2.840.10008.1.2.4.202", {Codec::unsupported, "High-Throughput JPEG 2000 RPCL Lossless"}},
    {"1.2.840.10008.1.2.4.203", {Codec::unsupported, "High-Throughput JPEG 2000"}},
});

}  // namespace

TransferSyntaxInfo transferSyntaxInfo(std::string_view uid) {
    const auto row = std::find_if(kTable.begin(), kTable.end(), [&](const Row& r) { return r.uid == uid; });
    return row == kTable.end() ? TransferSyntaxInfo{} : row->info;
}

std::string describeTransferSyntax(std::string_view uid) {
    const bool isUid =
        !uid.empty() && uid.size() <= 64 && uid.find_first_not_of("0123456789.") == std::string_view::npos;
    const std::string_view name = transferSyntaxInfo(uid).name;
    return fmt::format("{} ({})", name.empty() ? "unknown compression" : name,
                       isUid ? uid : "no valid identifier");
}

bool isLossy(std::string_view uid) {
    return uid == "1.2.840.10008.1.2.4.50" || uid == "1.2.840.10008.1.2.4.51" ||
           uid == "1.2.840.10008.1.2.4.53" || uid == "1.2.840.10008.1.2.4.55" ||
           uid == "1.2.840.10008.1.2.4.81";
}

}  // namespace macula::dicom
