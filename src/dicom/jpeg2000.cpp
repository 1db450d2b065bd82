#include "dicom/jpeg2000.h"

#include <gdcmByteValue.h>
#include <gdcmDataElement.h>
#include <gdcmJPEG2000Codec.h>
#include <gdcmPhotometricInterpretation.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <mutex>

namespace macula::dicom {

namespace {

Error broken() {
    return {ErrorCode::inputNotUsable,
            "The JPEG 2000 image in this file cannot be decoded.",
            {},
            "Copy the file again from its source."};
}

}  // namespace

Result<void> decodeJpeg2000(std::span<const std::byte> codeStream, int columns, int rows,
                            const CellFormat& format, std::span<std::uint16_t> cells) try {
    static std::once_flag silence;
    std::call_once(silence, [] {
        gdcm::Trace::DebugOff();
        gdcm::Trace::WarningOff();
        gdcm::Trace::ErrorOff();
    });
    if (codeStream.empty() || codeStream.size() > std::numeric_limits<std::uint32_t>::max()) return broken();

    gdcm::JPEG2000Codec codec;
    const unsigned int dimensions[3] = {static_cast<unsigned>(columns), static_cast<unsigned>(rows), 1};
    codec.SetNumberOfDimensions(2);
    codec.SetDimensions(dimensions);
    codec.SetPlanarConfiguration(0);
    codec.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
    codec.SetPixelFormat(gdcm::PixelFormat(
        1, static_cast<unsigned short>(format.bitsAllocated), static_cast<unsigned short>(format.bitsStored),
        static_cast<unsigned short>(format.highBit), format.isSigned ? 1 : 0));
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

    // The code stream itself says whether its samples take one byte or two.
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
