#include "dicom/pixels/decoders.h"

#include <openjpeg.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <vector>

namespace macula::dicom {

namespace {

Error broken() {
    return {ErrorCode::inputNotUsable,
            Text("The JPEG 2000 image in this file cannot be decoded."),
            {},
            Text("Copy the file again from its source.")};
}

// The header of a code stream (ISO 15444-1 A.5.1).
struct StreamHeader {
    std::size_t begin = 0;  // offset of the code stream: a JP2 file may be wrapped around it
    unsigned columns = 0;
    unsigned rows = 0;
    unsigned components = 0;
    unsigned precision = 0;
};

// Whether every tile has a part in the stream (ISO 15444-1 A.4.2, B.3). The decoder takes memory for each
// tile that the header announces, and silently fills missing ones with zeros.
bool hasAllTiles(std::span<const std::byte> stream, std::size_t firstTilePart, std::uint64_t tiles) {
    // Size of an empty tile-part: start of tile-part and start of data.
    constexpr std::size_t kTilePartBytes = 14;
    constexpr unsigned kStartOfTilePart = 0xFF90;
    if (tiles == 0 || tiles > stream.size() / kTilePartBytes) return false;
    const auto number = [&](std::size_t at, std::size_t size) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < size; ++i)
            value = value << 8 | std::to_integer<std::uint32_t>(stream[at + i]);
        return value;
    };
    std::vector<bool> seen(tiles, false);
    for (std::size_t at = firstTilePart; at + kTilePartBytes <= stream.size();) {
        if (number(at, 2) != kStartOfTilePart) break;  // the end of the code stream
        const std::uint32_t tile = number(at + 4, 2);
        if (tile >= tiles) return false;
        seen[tile] = true;
        const std::uint32_t bytes = number(at + 6, 4);
        if (bytes == 0) break;  // up to the end
        if (bytes < kTilePartBytes) return false;
        at += bytes;
    }
    return std::find(seen.begin(), seen.end(), false) == seen.end();
}

// Reads the header, and walks the marker segments up to the data, before the decoder takes memory for what
// they announce.
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
    constexpr std::size_t kSizBytes = 45;  // size of SOC and SIZ with one component
    constexpr std::size_t kBytesOfComponent = 3;
    if (stream.size() < kSizBytes) return {};
    header.columns = number(8, 4) - number(16, 4);
    header.rows = number(12, 4) - number(20, 4);
    header.components = number(40, 2);
    header.precision = (number(42, 1) & 0x7F) + 1;
    for (std::size_t c = 0; c < std::min(header.components, 3u); ++c) {
        const std::size_t at = 42 + c * kBytesOfComponent;
        if (at + kBytesOfComponent > stream.size()) return {};
        const bool isOther = (number(at, 1) & 0x7F) + 1 != header.precision;
        if (isOther || number(at + 1, 2) != 0x0101) return {};  // subsampled
    }

    const auto tilesAlong = [&](std::size_t size, std::size_t tileSize, std::size_t tileOrigin) {
        const std::uint64_t end = number(size, 4);
        const std::uint64_t origin = number(tileOrigin, 4);
        const std::uint64_t step = number(tileSize, 4);
        return step == 0 || end <= origin ? 0 : (end - origin + step - 1) / step;
    };
    const std::uint64_t tilesX = tilesAlong(8, 24, 32);
    const std::uint64_t tilesY = tilesAlong(12, 28, 36);
    constexpr std::uint64_t kMostTiles = 65535;  // their number has 16 bits
    if (tilesX > kMostTiles || tilesY > kMostTiles || tilesX * tilesY > kMostTiles) return {};

    constexpr unsigned kStartOfTilePart = 0xFF90;
    std::optional<std::size_t> firstTilePart;
    bool hasCodingStyle = false;
    for (std::size_t at = 2; at + 4 <= stream.size();) {
        const std::uint32_t marker = number(at, 2);
        if (marker == kStartOfTilePart && !firstTilePart) firstTilePart = at;
        if (marker == kStartOfData) {
            const bool usable =
                hasCodingStyle && firstTilePart && hasAllTiles(stream, *firstTilePart, tilesX * tilesY);
            return usable ? std::optional(header) : std::nullopt;
        }
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

// The stream as the decoder reads it.
struct Reading {
    std::span<const std::byte> bytes;
    std::size_t at = 0;
};

OPJ_SIZE_T readBytes(void* target, OPJ_SIZE_T count, void* user) {
    Reading& reading = *static_cast<Reading*>(user);
    const std::size_t step = std::min<std::size_t>(count, reading.bytes.size() - reading.at);
    if (step == 0) return static_cast<OPJ_SIZE_T>(-1);
    std::memcpy(target, reading.bytes.data() + reading.at, step);
    reading.at += step;
    return step;
}

OPJ_OFF_T skipBytes(OPJ_OFF_T count, void* user) {
    Reading& reading = *static_cast<Reading*>(user);
    if (count < 0) return -1;
    const std::size_t left = reading.bytes.size() - reading.at;
    const std::size_t step = std::min<std::size_t>(static_cast<std::size_t>(count), left);
    reading.at += step;
    return step > 0 || count == 0 ? static_cast<OPJ_OFF_T>(step) : -1;
}

OPJ_BOOL seekBytes(OPJ_OFF_T to, void* user) {
    Reading& reading = *static_cast<Reading*>(user);
    if (to < 0 || static_cast<std::size_t>(to) > reading.bytes.size()) return OPJ_FALSE;
    reading.at = static_cast<std::size_t>(to);
    return OPJ_TRUE;
}

void ignoreMessage(const char*, void*) {}

// OpenJPEG's text "Not enough memory to ..." is all that distinguishes lack of memory from a broken stream.
void noteLackOfMemory(const char* text, void* lacksMemory) {
    if (text != nullptr && std::strstr(text, "memory") != nullptr) *static_cast<bool*>(lacksMemory) = true;
}

// The library's handles are all void pointers, so each kind needs a deleter of its own.
struct DestroyCodec {
    void operator()(opj_codec_t* codec) const { opj_destroy_codec(codec); }
};
struct DestroyStream {
    void operator()(opj_stream_t* stream) const { opj_stream_destroy(stream); }
};
struct DestroyImage {
    void operator()(opj_image_t* image) const { opj_image_destroy(image); }
};

}  // namespace

Result<void> decodeJpeg2000(std::span<const std::byte> codeStream, int columns, int rows,
                            std::span<std::uint16_t> cells) {
    const std::optional<StreamHeader> header = readHeader(codeStream);
    const std::size_t pixels = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    if (!header || (header->components != 1 && header->components != 3) || header->precision > 16 ||
        header->columns != static_cast<unsigned>(columns) || header->rows != static_cast<unsigned>(rows) ||
        cells.size() != header->components * pixels) {
        return broken();
    }

    Reading reading{codeStream.subspan(header->begin)};
    const std::unique_ptr<opj_stream_t, DestroyStream> stream(opj_stream_default_create(OPJ_TRUE));
    const std::unique_ptr<opj_codec_t, DestroyCodec> codec(opj_create_decompress(OPJ_CODEC_J2K));
    if (!stream || !codec) throw std::bad_alloc();
    opj_stream_set_user_data(stream.get(), &reading, nullptr);
    opj_stream_set_user_data_length(stream.get(), reading.bytes.size());
    opj_stream_set_read_function(stream.get(), readBytes);
    opj_stream_set_skip_function(stream.get(), skipBytes);
    opj_stream_set_seek_function(stream.get(), seekBytes);
    // Its messages help nobody, and would be printed to the terminal.
    opj_set_info_handler(codec.get(), ignoreMessage, nullptr);
    opj_set_warning_handler(codec.get(), ignoreMessage, nullptr);
    bool lacksMemory = false;
    opj_set_error_handler(codec.get(), noteLackOfMemory, &lacksMemory);

    opj_dparameters_t parameters;
    opj_set_default_decoder_parameters(&parameters);
    opj_image_t* made = nullptr;
    const bool hasHeader = opj_setup_decoder(codec.get(), &parameters) == OPJ_TRUE &&
                           opj_read_header(stream.get(), codec.get(), &made) == OPJ_TRUE;
    const std::unique_ptr<opj_image_t, DestroyImage> image(made);
    const auto failed = [&] {
        if (lacksMemory) throw std::bad_alloc();
        return broken();
    };
    if (!hasHeader || opj_decode(codec.get(), stream.get(), image.get()) != OPJ_TRUE) return failed();
    const std::size_t components = header->components;
    if (image->numcomps != components) return broken();
    for (std::size_t c = 0; c < components; ++c) {
        const opj_image_comp_t& component = image->comps[c];
        if (component.data == nullptr || component.w != header->columns || component.h != header->rows)
            return broken();
        for (std::size_t i = 0; i < pixels; ++i)
            cells[i * components + c] = static_cast<std::uint16_t>(component.data[i]);
    }
    return {};
}

}  // namespace macula::dicom
