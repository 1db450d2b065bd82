#include "dicom/pixels.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>

#include <mutex>

#include "base/log.h"
#include "dicom/jpeg2000.h"
#include "dicom/outline.h"
#include "dicom/transfer_syntax.h"

namespace macula::dicom {

namespace {

void registerDecoders() {
    static std::once_flag once;
    std::call_once(once, [] {
        DcmRLEDecoderRegistration::registerCodecs();
        DJDecoderRegistration::registerCodecs();
        DJLSDecoderRegistration::registerCodecs();
    });
}

struct Fragment {
    const Uint8* bytes = nullptr;
    std::size_t size = 0;
};

// The fragments of an encapsulated pixel data element (PS3.5 A.4), without the offset table.
std::vector<Fragment> fragmentsOf(DcmPixelData& pixelData, E_TransferSyntax syntax) {
    std::vector<Fragment> fragments;
    DcmPixelSequence* sequence = nullptr;
    if (pixelData.getEncapsulatedRepresentation(syntax, nullptr, sequence).bad() || sequence == nullptr)
        return {};
    for (unsigned long i = 1; i < sequence->card(); ++i) {
        DcmPixelItem* item = nullptr;
        Uint8* bytes = nullptr;
        if (sequence->getItem(item, i).bad() || item->getUint8Array(bytes).bad() || bytes == nullptr)
            return {};
        fragments.push_back({bytes, item->getLength()});
    }
    return fragments;
}

// The sample precision of a JPEG or JPEG-LS stream: in its frame header (ISO 10918-1 B.2.2, ISO 14495-1
// C.2.2). Samples of up to 8 bits are decoded to one byte each, whatever BitsAllocated says.
std::optional<int> samplePrecision(const Fragment& stream) {
    std::size_t at = 2;  // after the start-of-image marker
    while (at + 5 <= stream.size && stream.bytes[at] == 0xFF) {
        const unsigned marker = stream.bytes[at + 1];
        const bool frameHeader =
            (marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC) ||
            marker == 0xF7;
        if (frameHeader) return stream.bytes[at + 4];
        at += 2u + (std::size_t{stream.bytes[at + 2]} << 8 | stream.bytes[at + 3]);
    }
    return {};
}

// The RLE header (PS3.5 G.5) names segments that follow each other inside the fragment. DCMTK does not check
// this, and reads wherever the header points.
bool isRleFrame(const Fragment& fragment) {
    constexpr std::size_t kHeaderBytes = 64;
    constexpr std::uint32_t kMostSegments = 15;
    const auto word = [&](std::size_t i) {
        const Uint8* b = fragment.bytes + 4 * i;
        return std::uint32_t{b[0]} | std::uint32_t{b[1]} << 8 | std::uint32_t{b[2]} << 16 |
               std::uint32_t{b[3]} << 24;
    };
    if (fragment.size <= kHeaderBytes || word(0) < 1 || word(0) > kMostSegments || word(1) != kHeaderBytes)
        return false;
    for (std::size_t i = 2; i <= word(0); ++i) {
        if (word(i) <= word(i - 1) || word(i) >= fragment.size) return false;
    }
    return true;
}

Result<void> decode(const Instance& instance, DcmFileFormat& file, std::span<std::uint16_t> cells) {
    const auto fail = [&](std::string message, std::string hint) {
        return Error{ErrorCode::inputNotUsable, std::move(message), instance.file.string(), std::move(hint)};
    };
    const std::string copyAgain = "Copy the file again from its source.";
    DcmDataset& dataset = *file.getDataset();
    Uint16 rows = 0;
    Uint16 columns = 0;
    Uint16 allocated = 0;
    dataset.findAndGetUint16(DCM_Rows, rows);
    dataset.findAndGetUint16(DCM_Columns, columns);
    dataset.findAndGetUint16(DCM_BitsAllocated, allocated);
    if (!instance.format || rows != instance.rows || columns != instance.columns ||
        allocated != instance.format->bitsAllocated || cells.size() != std::size_t{rows} * columns) {
        return fail("The file has changed since the folder was read.", "Open the folder again.");
    }
    DcmElement* element = nullptr;
    if (dataset.findAndGetElement(DCM_PixelData, element).bad() || element == nullptr) {
        return fail("The file has no pixel data.", copyAgain);
    }

    const Codec codec = transferSyntaxInfo(instance.transferSyntaxUid).codec;
    bool oneByteSamples = allocated == 8;
    if (codec != Codec::native) {
        auto* pixelData = dynamic_cast<DcmPixelData*>(element);
        const auto fragments = pixelData != nullptr ? fragmentsOf(*pixelData, dataset.getOriginalXfer())
                                                    : std::vector<Fragment>{};
        if (fragments.empty())
            return fail("The compressed image in this file is missing or cut off.", copyAgain);
        if (codec == Codec::jpeg2000) {
            std::vector<std::byte> stream;
            for (const Fragment& fragment : fragments) {
                const auto* bytes = reinterpret_cast<const std::byte*>(fragment.bytes);
                stream.insert(stream.end(), bytes, bytes + fragment.size);
            }
            auto decoded = decodeJpeg2000(stream, columns, rows, cells);
            if (!decoded) return fail(decoded.error().message, decoded.error().hint);
            return {};
        }
        const std::string damaged = "The compressed image in this file is damaged.";
        if (codec == Codec::rle) {
            if (fragments.size() != 1 || !isRleFrame(fragments.front())) return fail(damaged, copyAgain);
        } else {
            const auto precision = samplePrecision(fragments.front());
            if (!precision) return fail(damaged, copyAgain);
            if (*precision <= 8 && !oneByteSamples) {
                oneByteSamples = true;
                dataset.putAndInsertUint16(DCM_BitsAllocated, 8);  // of this copy, for the decoder to agree
            }
        }
    }

    Uint32 startFragment = 0;
    OFString colourModel;
    std::vector<std::uint8_t> narrow;
    void* target = cells.data();
    std::size_t bytes = cells.size_bytes();
    if (oneByteSamples) {
        narrow.resize(cells.size() + cells.size() % 2);
        target = narrow.data();
        bytes = narrow.size();
    }
    const OFCondition status = element->getUncompressedFrame(&dataset, 0, startFragment, target,
                                                             static_cast<Uint32>(bytes), colourModel);
    if (status.bad()) {
        log::warning("pixels of {}: {}", log::Sensitive{instance.file.native()}, status.text());
        return fail("The pixel data of this file are damaged or cut off.", copyAgain);
    }
    if (oneByteSamples) std::copy_n(narrow.begin(), cells.size(), cells.begin());
    return {};
}

}  // namespace

Result<void> decodeCells(const Instance& instance, std::span<std::uint16_t> cells) try {
    silenceToolkit();
    registerDecoders();
    if (transferSyntaxInfo(instance.transferSyntaxUid).codec == Codec::unsupported) {
        return Error{ErrorCode::inputNotUsable,
                     fmt::format("This version cannot decode this image: {}.",
                                 describeTransferSyntax(instance.transferSyntaxUid)),
                     instance.file.string(), "Export the series uncompressed or in JPEG 2000."};
    }
    const Outline outline = outlineOf(instance.file, hasPreamble(instance.file));
    const Error cutOff{ErrorCode::inputNotUsable,
                       "The file cannot be read, or ends before its pixel data do.", instance.file.string(),
                       "Copy the file again from its source."};
    if (!outline.isSafeToParse()) return cutOff;
    DcmFileFormat file;
    constexpr Uint32 kLongestValueRead = 4096;  // the pixels stay in the file until decoded
    const OFCondition status =
        file.loadFileUntilTag(instance.file.c_str(), EXS_Unknown, EGL_noChange, kLongestValueRead,
                              ERM_autoDetect, DcmTagKey(0x7FE0, 0x0011));
    if (status.bad() && !outline.strayBytesAfterPixels) return cutOff;
    return decode(instance, file, cells);
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, "There is not enough memory to decode a slice.",
                 instance.file.string(), "Close other programs, or choose a smaller series."};
} catch (...) {
    return Error{ErrorCode::inputNotUsable, "The pixel data of this file cannot be decoded.",
                 instance.file.string(), "Copy the file again from its source."};
}

}  // namespace macula::dicom
