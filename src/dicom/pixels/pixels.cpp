#include "dicom/pixels/pixels.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "base/check.h"
#include "dicom/pixels/decoders.h"
#include "dicom/pixels/frame_index.h"
#include "dicom/read/byte_source.h"
#include "dicom/read/dataset.h"
#include "dicom/read/outline.h"
#include "dicom/read/values.h"

namespace macula::dicom {

static_assert(std::endian::native == std::endian::little, "cells are used as they are in the file");

namespace {

constexpr Tag kExtendedOffsetTable{0x7FE0, 0x0001};
constexpr std::string_view kBigEndian = "1.2.840.10008.1.2.2";

Tag pixelTagOf(CellKind kind) {
    switch (kind) {
        case CellKind::float32:
            return {0x7FE0, 0x0008};
        case CellKind::float64:
            return {0x7FE0, 0x0009};
        case CellKind::integer:
            break;
    }
    return tag::kPixelData;
}

// The number that the header gives now, in any VR, as Dataset::integer reads it; nothing if there is none.
std::optional<double> numberOf(const ElementTree& tree, Tag tag) {
    const Element* element = tree.find(tree.root(), tag);
    if (element == nullptr) return {};
    const Vr vr = element->vr == 0 || element->vr == vrOf("UN") ? dictionaryVr(tag) : element->vr;
    if (isTextVr(vr)) return finiteNumber(tree.value(*element));
    const auto values = binaryNumbers(vr, tree.value(*element), element->bigEndian);
    return values.size() == 1 ? std::optional(values.front()) : std::nullopt;
}

std::vector<std::uint64_t> extendedOffsets(const ElementTree& tree) {
    const Element* element = tree.find(tree.root(), kExtendedOffsetTable);
    if (element == nullptr) return {};
    const std::string_view value = tree.value(*element);
    std::vector<std::uint64_t> offsets(value.size() / sizeof(std::uint64_t));
    if (!offsets.empty()) std::memcpy(offsets.data(), value.data(), offsets.size() * sizeof(std::uint64_t));
    return offsets;
}

template <class T>
T at(std::span<const std::byte> bytes, std::size_t i) {
    T value;
    std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
    return value;
}

// Little-endian cells of any format to raw values.
void toNumbers(const CellFormat& format, std::span<const std::byte> bytes, std::span<double> numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (format.kind == CellKind::float32) {
            numbers[i] = at<float>(bytes, i);
        } else if (format.kind == CellKind::float64) {
            numbers[i] = at<double>(bytes, i);
        } else {
            // Shifts the stored bits to the top of the word, and back with or without their sign.
            const std::uint32_t top = at<std::uint32_t>(bytes, i) << (31 - format.highBit);
            const int down = 32 - format.bitsStored;
            numbers[i] =
                format.isSigned ? double(static_cast<std::int32_t>(top) >> down) : double(top >> down);
        }
    }
}

}  // namespace

struct PixelReader::Impl {
    std::filesystem::path path;
    PixelLayout layout;
    CancelToken cancel;
    RandomFile file;
    Codec codec = Codec::native;
    PixelDataOutline pixels;
    FrameIndex index;  // frames of encapsulated pixel data
    bool bigEndian = false;
    bool isSubsampled = false;              // native: two pixels share their colour differences
    bool bytesInWords = false;              // big endian, and OW: bytes are swapped too (PS3.5 7.3)
    std::uint64_t datasetOffset = 0;        // where deflated data begin
    std::unique_ptr<ByteSource> inflating;  // a deflated file that is being read, somewhere in its pixels
    std::vector<std::byte> scratch;

    Impl(const std::filesystem::path& p, const PixelLayout& l, CancelToken c)
        : path(p), layout(l), cancel(std::move(c)), file(p) {}

    Error fail(Text message, Text hint = Text("Copy the file again from its source.")) const {
        return {ErrorCode::inputNotUsable, std::move(message), path.string(), std::move(hint)};
    }
    Error damaged() const { return fail(Text("The pixel data of this file are damaged.")); }
    Error cutOff() const { return fail(Text("The file ends before its pixel data do.")); }

    std::size_t cellCount() const {
        return static_cast<std::size_t>(layout.rows) * static_cast<std::size_t>(layout.columns);
    }
    std::uint64_t frameBits() const {
        return std::uint64_t{cellCount()} * static_cast<unsigned>(layout.format.bitsAllocated) *
               static_cast<unsigned>(isSubsampled ? 2 : layout.samplesPerPixel);
    }
    std::size_t bytesPerCell() const { return static_cast<std::size_t>(layout.format.bitsAllocated) / 8; }

    Result<void> open();
    bool isCutOff(int frame) const;
    bool gather(std::size_t frame);
    bool readNative(std::uint64_t offset, std::span<std::byte> bytes);
    Result<void> readBytes(int frame, std::span<std::byte> bytes);
    Result<void> readBits(int frame, std::span<std::uint16_t> cells);
    Result<void> readCells(int frame, std::span<std::uint16_t> cells);
    Result<void> readNumbers(int frame, std::span<double> numbers);
    Result<void> readNativeColours(int frame, std::span<std::uint16_t> samples);
    Result<std::string> readColours(int frame, std::span<std::uint16_t> samples);
};

Result<void> PixelReader::Impl::open() {
    codec = transferSyntaxInfo(layout.transferSyntaxUid).codec;
    if (codec == Codec::unsupported) {
        return fail(Text("This version cannot decode this image: {}.",
                         describeTransferSyntax(layout.transferSyntaxUid)),
                    Text("Export the series uncompressed or in JPEG 2000."));
    }
    if (!file.isOpen())
        return fail(Text("The file cannot be read."), Text("Check that the file or disc is still there."));
    ElementTree tree;
    ByteSource source(path, cancel);
    const Outline outline = outlineOf(source, hasPreamble(source), &tree);
    const auto same = [&](Tag tag, int wanted) { return numberOf(tree, tag).value_or(wanted) == wanted; };
    if (outline.transferSyntaxUid != layout.transferSyntaxUid || !same(tag::kRows, layout.rows) ||
        !same(tag::kColumns, layout.columns) || !same(tag::kBitsAllocated, layout.format.bitsAllocated)) {
        return fail(Text("The file has changed since the folder was read."), Text("Open the folder again."));
    }
    if (outline.inflatesTooFar) return damaged();
    if (!outline.pixels) return cutOff();
    pixels = *outline.pixels;
    if (pixels.tag != pixelTagOf(layout.format.kind))
        return fail(Text("The file has no pixel data that fit its header."));

    datasetOffset = outline.datasetOffset;
    if (source.inflating()) inflating = std::make_unique<ByteSource>(path, cancel);
    bigEndian = layout.transferSyntaxUid == kBigEndian;
    if (bigEndian && !pixels.encapsulated) {
        std::array<std::byte, 2> vr{};  // VR in the element header: tag, VR, two bytes, length
        if (pixels.offset < 12 || !file.read(pixels.offset - 8, vr)) return damaged();
        bytesInWords = vr == std::array{std::byte{'O'}, std::byte{'W'}};
    }
    const bool isNamedSubsampled = layout.samplesPerPixel == 3 && layout.format.bitsAllocated == 8 &&
                                   layout.photometricInterpretation.ends_with("_422");
    // Some writers say so, and give each pixel all three samples.
    isSubsampled = isNamedSubsampled && !pixels.encapsulated && layout.columns % 2 == 0 &&
                   pixels.claimed * 8 < frameBits() * static_cast<unsigned>(layout.frames);
    if (!pixels.encapsulated) {
        // The pixels may be compressed in name only: some archives change the transfer syntax and not the
        // pixels.
        const bool fits = pixels.claimed * 8 / frameBits() >= static_cast<unsigned>(layout.frames) &&
                          pixels.claimed * 8 % frameBits() < 16;
        if (codec != Codec::native && !fits) return damaged();
        codec = Codec::native;
        return {};
    }
    if (inflating) return damaged();
    auto found = indexFrames(file, pixels.offset, static_cast<std::size_t>(layout.frames), codec,
                             extendedOffsets(tree));
    if (!found) return fail(Text("It cannot be told where the images in this file begin."));
    index = std::move(*found);
    return {};
}

bool PixelReader::Impl::isCutOff(int frame) const {
    if (pixels.encapsulated) return static_cast<std::size_t>(frame) >= index.frames();
    return static_cast<std::uint64_t>(frame) >= pixels.present * 8 / frameBits();
}

// Gathers the stream of a frame into scratch.
bool PixelReader::Impl::gather(std::size_t frame) {
    std::uint64_t bytes = 0;
    for (const Extent& extent : index[frame]) bytes += extent.bytes;  // all inside the file
    scratch.resize(bytes);
    std::size_t filled = 0;
    for (const Extent& extent : index[frame]) {
        if (!file.read(extent.offset, std::span(scratch).subspan(filled, extent.bytes))) return false;
        filled += extent.bytes;
    }
    return true;
}

// Reads native pixels, `offset` bytes from their beginning.
bool PixelReader::Impl::readNative(std::uint64_t offset, std::span<std::byte> bytes) {
    if (!inflating) return file.read(pixels.offset + offset, bytes);
    if (!inflating->inflating() || inflating->position() > pixels.offset + offset) {
        inflating = std::make_unique<ByteSource>(path, cancel);
        if (!inflating->skip(datasetOffset)) return false;
        inflating->beginInflating();
    }
    return inflating->skip(pixels.offset + offset - inflating->position()) &&
           inflating->read({reinterpret_cast<unsigned char*>(bytes.data()), bytes.size()});
}

// Reads cells of whole bytes that are native or run-length encoded; little-endian.
Result<void> PixelReader::Impl::readBytes(int frame, std::span<std::byte> bytes) {
    const std::size_t cell = bytesPerCell();
    if (codec == Codec::rle) {
        if (!gather(static_cast<std::size_t>(frame)) || !decodeRle(scratch, cell, bytes)) return damaged();
        return {};
    }
    if (codec != Codec::native) return damaged();  // JPEG 2000 of more than 16 bits
    if (pixels.encapsulated) {
        if (!gather(static_cast<std::size_t>(frame)) || scratch.size() < bytes.size()) return damaged();
        std::copy_n(scratch.begin(), bytes.size(), bytes.begin());
        return {};
    }
    const std::uint64_t offset = static_cast<std::uint64_t>(frame) * bytes.size();
    if (bigEndian && cell == 1 && bytesInWords) {
        // Pairs of bytes are swapped, counted from the first frame.
        const std::uint64_t first = offset - offset % 2;
        const std::uint64_t end = offset + bytes.size() + (offset + bytes.size()) % 2;
        scratch.resize(end - first);
        if (!readNative(first, scratch)) return cutOff();
        for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = scratch[((offset + i) ^ 1) - first];
        return {};
    }
    if (!readNative(offset, bytes)) return cutOff();
    if (bigEndian && cell > 1) {
        for (std::size_t i = 0; i < bytes.size(); i += cell) std::ranges::reverse(bytes.subspan(i, cell));
    }
    return {};
}

// Frames of single bits follow each other without a gap (PS3.5 8.1.1).
Result<void> PixelReader::Impl::readBits(int frame, std::span<std::uint16_t> cells) {
    std::uint64_t firstBit = 0;
    if (pixels.encapsulated) {
        if (codec != Codec::native || !gather(static_cast<std::size_t>(frame)) ||
            scratch.size() * 8 < cells.size())
            return damaged();
    } else {
        const std::uint64_t begin = static_cast<std::uint64_t>(frame) * cells.size();
        const std::uint64_t first = begin / 16 * 2;  // whole words, for the sake of big endian
        std::uint64_t end = (begin + cells.size() + 7) / 8;
        if (bytesInWords) end += end % 2;
        scratch.resize(end - first);
        if (!readNative(first, scratch)) return cutOff();
        if (bytesInWords) {
            for (std::size_t i = 0; i + 1 < scratch.size(); i += 2) std::swap(scratch[i], scratch[i + 1]);
        }
        firstBit = begin - first * 8;
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::uint64_t bit = firstBit + i;
        cells[i] = std::to_integer<unsigned>(scratch[bit / 8]) >> (bit % 8) & 1u;
    }
    return {};
}

Result<void> PixelReader::Impl::readCells(int frame, std::span<std::uint16_t> cells) {
    if (isCutOff(frame)) return cutOff();
    if (layout.format.bitsAllocated == 1) return readBits(frame, cells);
    if (codec == Codec::jpeg || codec == Codec::jpegLs || codec == Codec::jpeg2000) {
        if (!gather(static_cast<std::size_t>(frame))) return cutOff();
        Result<void> decoded =
            codec == Codec::jpeg2000
                ? decodeJpeg2000(scratch, layout.columns, layout.rows, cells)
                : decodeJpeg(layout.transferSyntaxUid, scratch, layout.columns, layout.rows, cells);
        if (!decoded) return fail(decoded.error().message, decoded.error().hint);
        return {};
    }
    if (layout.format.bitsAllocated == 16) return readBytes(frame, std::as_writable_bytes(cells));
    std::vector<std::byte> narrow(cells.size());
    MACULA_TRY_VOID(readBytes(frame, narrow));
    std::ranges::transform(narrow, cells.begin(),
                           [](std::byte b) { return std::to_integer<std::uint16_t>(b); });
    return {};
}

Result<void> PixelReader::Impl::readNumbers(int frame, std::span<double> numbers) {
    const CellFormat& format = layout.format;
    if (isNarrow(format)) {
        std::vector<std::uint16_t> cells(numbers.size());
        MACULA_TRY_VOID(readCells(frame, cells));
        unpackCells(format, {}, cells);
        const int offset = format.isSigned ? 32768 : 0;
        std::ranges::transform(cells, numbers.begin(),
                               [&](std::uint16_t cell) { return double(cell - offset); });
        return {};
    }
    if (isCutOff(frame)) return cutOff();
    std::vector<std::byte> bytes(numbers.size() * bytesPerCell());
    MACULA_TRY_VOID(readBytes(frame, bytes));
    toNumbers(format, bytes, numbers);
    return {};
}

// Native, or run-length encoded.
Result<void> PixelReader::Impl::readNativeColours(int frame, std::span<std::uint16_t> samples) {
    const std::size_t cell = bytesPerCell();
    std::vector<std::byte> bytes(static_cast<std::size_t>(frameBits() / 8));
    if (codec == Codec::rle) {
        // The three samples make one cell, with the first in its highest bytes.
        if (!gather(static_cast<std::size_t>(frame)) || !decodeRle(scratch, 3 * cell, bytes))
            return damaged();
    } else {
        MACULA_TRY_VOID(readBytes(frame, bytes));
    }
    const auto sampleAt = [&](std::size_t place) {
        const unsigned low = std::to_integer<unsigned>(bytes[place * cell]);
        const unsigned high = cell == 2 ? std::to_integer<unsigned>(bytes[place * cell + 1]) : 0;
        return static_cast<std::uint16_t>(low | high << 8);
    };
    const std::size_t count = cellCount();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            std::size_t place = 3 * i + c;
            if (codec == Codec::rle) place = 3 * i + 2 - c;
            // Two luminances, and the differences of both (PS3.3 C.7.6.3.1.2).
            else if (isSubsampled)
                place = c == 0 ? i / 2 * 4 + i % 2 : i / 2 * 4 + 1 + c;
            else if (layout.isByPlane)
                place = c * count + i;
            samples[3 * i + c] = sampleAt(place);
        }
    }
    return {};
}

Result<std::string> PixelReader::Impl::readColours(int frame, std::span<std::uint16_t> samples) {
    if (isCutOff(frame)) return cutOff();
    const std::string& said = layout.photometricInterpretation;
    if (codec == Codec::native || codec == Codec::rle) {
        MACULA_TRY_VOID(readNativeColours(frame, samples));
        return said;
    }
    if (!gather(static_cast<std::size_t>(frame))) return cutOff();
    if (codec == Codec::jpeg2000) {
        if (auto decoded = decodeJpeg2000(scratch, layout.columns, layout.rows, samples); !decoded)
            return fail(decoded.error().message, decoded.error().hint);
        return said == "YBR_FULL" ? said : "RGB";
    }
    auto decoded =
        decodeJpegColours(layout.transferSyntaxUid, scratch, said, layout.columns, layout.rows, samples);
    if (!decoded) return fail(decoded.error().message, decoded.error().hint);
    return *std::move(decoded);
}

PixelReader::PixelReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PixelReader::PixelReader(PixelReader&&) noexcept = default;
PixelReader& PixelReader::operator=(PixelReader&&) noexcept = default;
PixelReader::~PixelReader() = default;

namespace {

// Runs `body`, which may meet a hostile file, and turns what it throws into an error.
template <class Body>
auto guarded(const std::filesystem::path& file, const Body& body) -> decltype(body()) try {
    return body();
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, Text("There is not enough memory to decode a slice."), file.string(),
                 Text("Close other programs, or choose a smaller series.")};
} catch (const CheckFailure&) {
    throw;  // a bug in Macula, not a fault of the file
} catch (...) {
    return Error{ErrorCode::inputNotUsable, Text("The pixel data of this file cannot be decoded."),
                 file.string(), Text("Copy the file again from its source.")};
}

}  // namespace

Result<PixelReader> PixelReader::open(const std::filesystem::path& file, const PixelLayout& layout,
                                      CancelToken cancel) {
    MACULA_CHECK(isUsable(layout.format));
    return guarded(file, [&]() -> Result<PixelReader> {
        auto impl = std::make_unique<Impl>(file, layout, std::move(cancel));
        const int least = std::min({layout.columns, layout.rows, layout.frames});
        if (least < 1 || std::max(layout.columns, layout.rows) > kMostRows)
            return impl->fail(Text("The images of this file have no usable size."),
                              Text("Choose another series."));
        MACULA_TRY_VOID(impl->open());
        return PixelReader(std::move(impl));
    });
}

bool PixelReader::isCutOff(int frame) const {
    return impl_->isCutOff(frame);
}

Result<void> PixelReader::read(int frame, std::span<std::uint16_t> cells) {
    MACULA_CHECK(isNarrow(impl_->layout.format) && frame >= 0 && frame < impl_->layout.frames);
    MACULA_CHECK_EQ(impl_->layout.samplesPerPixel, 1);
    MACULA_CHECK_EQ(cells.size(), impl_->cellCount());
    return guarded(impl_->path, [&] { return impl_->readCells(frame, cells); });
}

Result<void> PixelReader::readNumbers(int frame, std::span<double> numbers) {
    MACULA_CHECK(frame >= 0 && frame < impl_->layout.frames);
    MACULA_CHECK_EQ(numbers.size(), impl_->cellCount());
    return guarded(impl_->path, [&] { return impl_->readNumbers(frame, numbers); });
}

Result<std::string> PixelReader::readColours(int frame, std::span<std::uint16_t> samples) {
    const PixelLayout& layout = impl_->layout;
    const int bits = layout.format.bitsAllocated;
    MACULA_CHECK(layout.samplesPerPixel == 3 && (bits == 8 || bits == 16));
    MACULA_CHECK(frame >= 0 && frame < layout.frames);
    MACULA_CHECK_EQ(samples.size(), 3 * impl_->cellCount());
    return guarded(impl_->path, [&] { return impl_->readColours(frame, samples); });
}

}  // namespace macula::dicom
