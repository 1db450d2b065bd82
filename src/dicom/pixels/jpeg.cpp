#include "dicom/pixels/decoders.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>

#include <cstring>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <optional>

#include "toolkit/quiet_toolkit.h"

namespace macula::dicom {

namespace {

Error broken() {
    return {ErrorCode::inputNotUsable,
            Text("The compressed image in this file is damaged."),
            {},
            Text("Copy the file again from its source.")};
}

void registerDecoders() {
    static std::once_flag once;
    std::call_once(once, [] {
        DJDecoderRegistration::registerCodecs();
        DJLSDecoderRegistration::registerCodecs();
    });
}

struct FrameHeader {
    int precision = 0;
    int rows = 0;
    int columns = 0;
    int components = 0;
};

// Reads the frame header (ISO 10918-1 B.2.2, ISO 14495-1 C.2.2). Nothing when there is none before the data.
std::optional<FrameHeader> readFrameHeader(std::span<const std::byte> stream) {
    const auto byte = [&](std::size_t i) { return std::to_integer<int>(stream[i]); };
    const auto word = [&](std::size_t i) { return byte(i) << 8 | byte(i + 1); };
    constexpr int kStartOfScan = 0xDA;
    std::size_t at = 2;  // after the start-of-image marker
    while (at + 10 <= stream.size() && byte(at) == 0xFF) {
        const int marker = byte(at + 1);
        if (marker == 0xFF) {  // a fill byte
            ++at;
            continue;
        }
        const bool isFrameHeader =
            (marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC) ||
            marker == 0xF7;
        if (isFrameHeader)
            return FrameHeader{.precision = byte(at + 4),
                               .rows = word(at + 5),
                               .columns = word(at + 7),
                               .components = byte(at + 9)};
        if (marker == kStartOfScan || word(at + 2) < 2) return {};
        at += 2 + static_cast<std::size_t>(word(at + 2));
    }
    return {};
}

// Decodes the stream as a data element of its own, with the few attributes that DCMTK's decoders need.
// `photometric` becomes that of the samples.
bool decodeWithToolkit(const std::string& transferSyntaxUid, std::span<const std::byte> stream,
                       const FrameHeader& header, std::string& photometric, std::span<std::byte> target) {
    DcmItem attributes;
    const auto put = [&](const DcmTagKey& key, int value) {
        return attributes.putAndInsertUint16(key, static_cast<Uint16>(value)).good();
    };
    const bool isSet =
        put(DCM_Rows, header.rows) && put(DCM_Columns, header.columns) &&
        put(DCM_SamplesPerPixel, header.components) && put(DCM_PlanarConfiguration, 0) &&
        put(DCM_BitsAllocated, header.precision <= 8 ? 8 : 16) && put(DCM_BitsStored, header.precision) &&
        put(DCM_HighBit, header.precision - 1) && put(DCM_PixelRepresentation, 0) &&
        attributes.putAndInsertString(DCM_PhotometricInterpretation, photometric.c_str()).good();
    if (!isSet) return false;

    // Elements are of even length (PS3.5 A.4).
    const std::size_t bytes = stream.size() + stream.size() % 2;
    if (bytes > std::numeric_limits<Uint32>::max()) return false;
    auto sequence = std::make_unique<DcmPixelSequence>(DCM_PixelSequenceTag);
    auto table = std::make_unique<DcmPixelItem>(DCM_PixelItemTag);
    if (sequence->insert(table.get()).bad()) return false;
    (void)table.release();
    auto fragment = std::make_unique<DcmPixelItem>(DCM_PixelItemTag);
    Uint8* copy = nullptr;
    if (fragment->createUint8Array(static_cast<Uint32>(bytes), copy).bad() || copy == nullptr) return false;
    copy[bytes - 1] = 0;
    std::memcpy(copy, stream.data(), stream.size());
    if (sequence->insert(fragment.get()).bad()) return false;
    (void)fragment.release();

    DcmPixelData pixels(DCM_PixelData);
    pixels.putOriginalRepresentation(DcmXfer(transferSyntaxUid.c_str()).getXfer(), nullptr,
                                     sequence.release());
    Uint32 startFragment = 0;
    OFString colourModel;
    const OFCondition decoded = pixels.getUncompressedFrame(&attributes, 0, startFragment, target.data(),
                                                            static_cast<Uint32>(target.size()), colourModel);
    // libjpeg reports lack of memory only in words: "Insufficient memory (case 4)".
    const bool noMemory =
        decoded == EC_MemoryExhausted || (decoded.bad() && std::strstr(decoded.text(), "memory"));
    if (noMemory) throw std::bad_alloc();
    if (!colourModel.empty()) photometric = colourModel.c_str();
    return decoded.good();
}

// Into samples of 16 bits, of one or three components.
Result<std::string> decode(const std::string& transferSyntaxUid, std::span<const std::byte> stream,
                           std::string photometric, int columns, int rows, int components,
                           std::span<std::uint16_t> samples) {
    const QuietToolkit quiet;
    registerDecoders();
    const auto header = readFrameHeader(stream);
    const std::size_t pixels = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    if (!header || header->precision < 2 || header->precision > 16 || header->components != components ||
        header->columns != columns || header->rows != rows ||
        samples.size() != pixels * static_cast<std::size_t>(components) ||
        samples.size_bytes() > std::numeric_limits<Uint32>::max() - 2) {
        return broken();
    }
    if (header->precision > 8) {
        if (!decodeWithToolkit(transferSyntaxUid, stream, *header, photometric,
                               std::as_writable_bytes(samples)))
            return broken();
        return photometric;
    }
    // Samples of up to 8 bits are decoded to one byte each, whatever BitsAllocated says.
    std::vector<std::byte> narrow(samples.size() + samples.size() % 2);
    if (!decodeWithToolkit(transferSyntaxUid, stream, *header, photometric, narrow)) return broken();
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = std::to_integer<std::uint16_t>(narrow[i]);
    return photometric;
}

}  // namespace

Result<void> decodeJpeg(const std::string& transferSyntaxUid, std::span<const std::byte> stream, int columns,
                        int rows, std::span<std::uint16_t> cells) {
    MACULA_TRY_VOID(decode(transferSyntaxUid, stream, "MONOCHROME2", columns, rows, 1, cells));
    return {};
}

Result<std::string> decodeJpegColours(const std::string& transferSyntaxUid, std::span<const std::byte> stream,
                                      const std::string& photometricInterpretation, int columns, int rows,
                                      std::span<std::uint16_t> samples) {
    return decode(transferSyntaxUid, stream, photometricInterpretation, columns, rows, 3, samples);
}

}  // namespace macula::dicom
