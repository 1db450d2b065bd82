#include "dicom/read/transfer_syntax.h"

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
    {"1.2.840.10008.1.2.4.201", {Codec::jpeg2000, "High-Throughput JPEG 2000 Lossless"}},
    {"1.2.840.10008.1.2.4.202", {Codec::jpeg2000, "High-Throughput JPEG 2000 RPCL Lossless"}},
    {"1.2.840.10008.1.2.4.203", {Codec::jpeg2000, "High-Throughput JPEG 2000"}},
    // These are known by name only, so that messages say more than a number.
    {"1.2.840.10008.1.2.4.92", {Codec::unsupported, "JPEG 2000 Multi-component Lossless"}},
    {"1.2.840.10008.1.2.4.93", {Codec::unsupported, "JPEG 2000 Multi-component"}},
    {"1.2.840.10008.1.2.4.100", {Codec::unsupported, "MPEG-2 video"}},
    {"1.2.840.10008.1.2.4.101", {Codec::unsupported, "MPEG-2 video"}},
    {"1.2.840.10008.1.2.4.102", {Codec::unsupported, "MPEG-4 video"}},
    {"1.2.840.10008.1.2.4.103", {Codec::unsupported, "MPEG-4 video"}},
    {"1.2.840.10008.1.2.4.104", {Codec::unsupported, "MPEG-4 video"}},
    {"1.2.840.10008.1.2.4.105", {Codec::unsupported, "MPEG-4 video"}},
    {"1.2.840.10008.1.2.4.106", {Codec::unsupported, "MPEG-4 video"}},
    {"1.2.840.10008.1.2.4.107", {Codec::unsupported, "HEVC video"}},
    {"1.2.840.10008.1.2.4.108", {Codec::unsupported, "HEVC video"}},
    {"1.2.840.10008.1.2.4.110", {Codec::unsupported, "JPEG XL Lossless"}},
    {"1.2.840.10008.1.2.4.111", {Codec::unsupported, "JPEG XL of a JPEG"}},
    {"1.2.840.10008.1.2.4.112", {Codec::unsupported, "JPEG XL"}},
    {"1.2.840.10008.1.2.8.1", {Codec::unsupported, "Deflated Image Frame"}},
});

constexpr std::string_view kJpegLossless = "1.2.840.10008.1.2.4.57";
constexpr std::string_view kJpegFirstOrder = "1.2.840.10008.1.2.4.70";

// The syntax of a stream by its frame header (ISO 10918-1 B.2.2, ISO 14495-1 C.2.2).
std::string_view syntaxOfJpeg(std::span<const unsigned char> stream) {
    std::size_t at = 2;
    while (at + 4 <= stream.size() && stream[at] == 0xFF) {
        switch (stream[at + 1]) {
            case 0xFF:  // a fill byte
                ++at;
                continue;
            case 0xC0:
                return "1.2.840.10008.1.2.4.50";
            case 0xC1:
                return "1.2.840.10008.1.2.4.51";
            case 0xC2:
                return "1.2.840.10008.1.2.4.55";
            case 0xC3:
                return kJpegLossless;
            case 0xF7:
                return "1.2.840.10008.1.2.4.80";
            default:
                at += 2 + (std::size_t{stream[at + 2]} << 8 | stream[at + 3]);
        }
    }
    return {};
}

// The header of run lengths: the number of segments, and the first of them right after it (PS3.5 G.5).
bool isRunLengths(std::span<const unsigned char> fragment) {
    constexpr std::array<unsigned char, 7> kRest{0, 0, 0, 64, 0, 0, 0};
    return fragment.size() > kRest.size() && fragment[0] >= 1 && fragment[0] <= 15 &&
           std::equal(kRest.begin(), kRest.end(), fragment.begin() + 1);
}

// A syntax that decodes a fragment that begins like this; empty when nothing is known.
std::string_view syntaxOf(std::span<const unsigned char> fragment) {
    if (isRunLengths(fragment)) return "1.2.840.10008.1.2.5";
    if (!beginsStream(fragment)) return {};
    if (fragment[0] == 0xFF && fragment[1] == 0xD8) return syntaxOfJpeg(fragment);
    // Rsiz of the SIZ marker: bit 14 stands for High-Throughput (ISO 15444-15 A.2).
    const bool isHighThroughput = fragment[0] == 0xFF && fragment.size() > 6 && (fragment[6] & 0x40u) != 0;
    return isHighThroughput ? "1.2.840.10008.1.2.4.203" : "1.2.840.10008.1.2.4.91";
}

}  // namespace

TransferSyntaxInfo transferSyntaxInfo(std::string_view uid) {
    const auto row = std::find_if(kTable.begin(), kTable.end(), [&](const Row& r) { return r.uid == uid; });
    return row == kTable.end() ? TransferSyntaxInfo{} : row->info;
}

Text describeTransferSyntax(std::string_view uid) {
    const bool isUid =
        !uid.empty() && uid.size() <= 64 && uid.find_first_not_of("0123456789.") == std::string_view::npos;
    const std::string_view name = transferSyntaxInfo(uid).name;
    return Text("{} ({})", name.empty() ? Text("unknown compression") : Text::verbatim(name),
                isUid ? Text::verbatim(uid) : Text("no valid identifier"));
}

bool beginsStream(std::span<const unsigned char> bytes) {
    const auto is = [&](std::initializer_list<unsigned char> wanted) {
        return bytes.size() >= wanted.size() && std::equal(wanted.begin(), wanted.end(), bytes.begin());
    };
    return is({0xFF, 0xD8, 0xFF}) || is({0xFF, 0x4F, 0xFF, 0x51}) ||
           is({0x00, 0x00, 0x00, 0x0C, 0x6A, 0x50, 0x20, 0x20}) || isRunLengths(bytes);
}

std::string_view syntaxInstead(std::string_view named, std::span<const unsigned char> fragment) {
    const std::string_view found = syntaxOf(fragment);
    const Codec codec = transferSyntaxInfo(named).codec;
    const Codec inUse = transferSyntaxInfo(found).codec;
    if (found.empty() || codec == Codec::unsupported) return {};
    // Pixels without compression, which may be in fragments too, can look like the header of run lengths.
    if (named == "1.2.840.10008.1.2.1.98" && inUse == Codec::rle) return {};
    if (codec != inUse) return found;
    // JPEG with loss and JPEG without have separate decoders.
    const auto isLossless = [](std::string_view uid) {
        return uid == kJpegLossless || uid == kJpegFirstOrder;
    };
    return codec == Codec::jpeg && isLossless(named) != isLossless(found) ? found : std::string_view();
}

bool isLossy(std::string_view uid) {
    return uid == "1.2.840.10008.1.2.4.50" || uid == "1.2.840.10008.1.2.4.51" ||
           uid == "1.2.840.10008.1.2.4.53" || uid == "1.2.840.10008.1.2.4.55" ||
           uid == "1.2.840.10008.1.2.4.81";
}

}  // namespace macula::dicom
