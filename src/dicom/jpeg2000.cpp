#include "dicom/jpeg2000.h"

#include <gdcmByteValue.h>
#include <gdcmDataElement.h>
#include <gdcmJPEG2000Codec.h>
#include <gdcmPhotometricInterpretation.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <mutex>
#include <optional>

namespace macula::dicom {

namespace {

Error broken() {
    return {ErrorCode::inputNotUsable,
            "The JPEG 2000 image in this file cannot be decoded.",
            {},
            "Copy the file again from its source."};
}

// What the header of a code stream says (ISO 15444-1 A.5.1).
struct StreamHeader {
    std::size_t begin = 0;  // of the code stream in the bytes: a JP2 file may be wrapped around it
    unsigned columns = 0;
    unsigned rows = 0;
    unsigned components = 0;
    unsigned precision = 0;
    bool isSigned = false;
};

// Reads the header, and walks the marker segments up to the data. This is done here because GDCM trusts the
// stream: it aborts the program (Debian builds it with assertions) when components or precision are not those
// announced, and follows the segment lengths wherever they lead.
std::optional<StreamHeader> readHeader(std::span<const std::byte> bytes) {
    constexpr std::array kStart{std::byte{0xFF}, std::byte{0x4F}, std::byte{0xFF},
                                std::byte{0x51}};  // SOC, SIZ
    constexpr unsigned kCodingStyle = 0xFF52;
    constexpr unsigned kStartOfData = 0xFF93;
    const auto found = std::search(bytes.begin(), bytes.end(), kStart.begin(), kStart.end());
    StreamHeader header;
    header.begin = static_cast<std::size_t>(found - bytes.begin());
    const std::span<const std::byte> stream = bytes.subspan(header.begin);
    const auto number = [&](std::size_t at, std::size_t size) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < size; ++i)
            value = value << 8 | std::to_integer<std::uint32_t>(stream[at + i]);
        return value;
    };
    constexpr std::size_t kSizBytes = 45;  // of SOC and SIZ with one component
    if (stream.size() < kSizBytes) return {};
    header.columns = number(8, 4) - number(16, 4);
    header.rows = number(12, 4) - number(20, 4);
    header.components = number(40, 2);
    header.precision = (number(42, 1) & 0x7F) + 1;
    header.isSigned = (number(42, 1) & 0x80) != 0;
    if (number(43, 2) != 0x0101) return {};  // subsampled

    bool hasCodingStyle = false;
    for (std::size_t at = 2; at + 4 <= stream.size();) {
        const std::uint32_t marker = number(at, 2);
        if (marker == kStartOfData) return hasCodingStyle ? std::optional(header) : std::nullopt;
        const std::uint32_t length = number(at + 2, 2);
        if (marker < 0xFF40 || length < 2 || at + 2 + length > stream.size()) return {};
        if (marker == kCodingStyle) {
            if (length < 12) return {};
            hasCodingStyle = true;
        }
        at += 2 + length;
    }
    return {};
}

}  // namespace

Result<void> decodeJpeg2000(std::span<const std::byte> codeStream, int columns, int rows,
                            std::span<std::uint16_t> cells) try {
    static std::once_flag silence;
    std::call_once(silence, [] {
        gdcm::Trace::DebugOff();
        gdcm::Trace::WarningOff();
        gdcm::Trace::ErrorOff();
    });
    if (codeStream.empty() || codeStream.size() > std::numeric_limits<std::uint32_t>::max()) return broken();

    const std::optional<StreamHeader> header = readHeader(codeStream);
    if (!header || header->components != 1 || header->precision > 16 ||
        header->columns != static_cast<unsigned>(columns) || header->rows != static_cast<unsigned>(rows) ||
        cells.size() != static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {
        return broken();
    }
    codeStream = codeStream.subspan(header->begin);

    gdcm::JPEG2000Codec codec;
    codec.SetNumberOfThreadsForDecompression(0);  // slices are decoded in parallel already
    const std::array dimensions{header->columns, header->rows, 1u};
    codec.SetNumberOfDimensions(2);
    codec.SetDimensions(dimensions.data());
    codec.SetPlanarConfiguration(0);
    codec.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
    // As in the stream, not as in the DICOM header: the stream decides how many bytes come out.
    const auto precision = static_cast<unsigned short>(header->precision);
    codec.SetPixelFormat(gdcm::PixelFormat(1, precision <= 8 ? 8 : 16, precision,
                                           static_cast<unsigned short>(precision - 1),
                                           header->isSigned ? 1 : 0));
    // The codec takes encapsulated pixel data only: one fragment.
    gdcm::Fragment fragment;
    fragment.SetByteValue(reinterpret_cast<const char*>(codeStream.data()),
                          gdcm::VL(static_cast<std::uint32_t>(codeStream.size())));
    const gdcm::SmartPointer<gdcm::SequenceOfFragments> fragments = new gdcm::SequenceOfFragments;
    fragments->AddFragment(fragment);
    gdcm::DataElement input(gdcm::Tag(0x7FE0, 0x0010));
    input.SetValue(*fragments);
    input.SetVLToUndefined();
    gdcm::DataElement output;
    if (!codec.Decode(input, output)) return broken();
    const gdcm::ByteValue* bytes = output.GetByteValue();
    if (bytes == nullptr) return broken();

    const std::size_t length = bytes->GetLength();
    if (length == cells.size_bytes()) {
        std::memcpy(cells.data(), bytes->GetPointer(), length);
    } else if (length == cells.size()) {
        std::transform(bytes->GetPointer(), bytes->GetPointer() + length, cells.begin(),
                       [](char c) { return static_cast<std::uint16_t>(static_cast<unsigned char>(c)); });
    } else {
        return broken();
    }
    return {};
} catch (...) {
    return broken();
}

}  // namespace macula::dicom
