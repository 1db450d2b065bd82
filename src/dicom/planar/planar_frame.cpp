#include "dicom/planar/planar_frame.h"

#include <algorithm>
#include <utility>

#include "base/available_memory.h"
#include "base/check.h"
#include "base/exceptions.h"
#include "dicom/frame_loader.h"
#include "dicom/pixels/pixels.h"

namespace macula::dicom {

namespace {

Error colourNotUsable(const Instance& instance) {
    return {ErrorCode::inputNotUsable, Text("This version cannot show an image in these colours."),
            instance.file.string(), Text("Export it as RGB.")};
}

Result<PixelReader> readerOf(const Instance& instance, bool isByPlane, const CancelToken& cancel) {
    const PixelLayout layout{.transferSyntaxUid = instance.transferSyntaxUid,
                             .columns = instance.columns,
                             .rows = instance.rows,
                             .frames = instance.frames,
                             .format = *instance.format,
                             .samplesPerPixel = instance.samplesPerPixel,
                             .photometricInterpretation = instance.photometricInterpretation,
                             .isByPlane = isByPlane};
    return PixelReader::open(instance.file, layout, cancel);
}

Result<PlanarFrame> colours(const Frame& frame, const PlanarHeader& header, const CancelToken& cancel) {
    const Instance& instance = *frame.instance;
    const bool hasSamples = instance.format->bitsAllocated == 8 || instance.format->bitsAllocated == 16;
    if (instance.samplesPerPixel != 3 || !hasSamples) return colourNotUsable(instance);
    MACULA_TRY(PixelReader reader, readerOf(instance, header.isByPlane, cancel));
    std::vector<std::uint16_t> samples(3 * std::size_t(instance.columns) * std::size_t(instance.rows));
    MACULA_TRY(const std::string photometric, reader.readColours(frame.number, samples));
    const std::optional<ColourModel> model = colourModelOf(photometric);
    if (!model) return colourNotUsable(instance);
    return PlanarFrame{.columns = instance.columns,
                       .rows = instance.rows,
                       .values = {},
                       .rgb = toRgb(*model, instance.format->bitsStored, samples)};
}

Result<PlanarFrame> paletteColours(const Frame& frame, const PlanarHeader& header,
                                   const CancelToken& cancel) {
    const Instance& instance = *frame.instance;
    if (!header.palette || instance.samplesPerPixel != 1 || !isNarrow(*instance.format))
        return colourNotUsable(instance);
    MACULA_TRY(PixelReader reader, readerOf(instance, false, cancel));
    std::vector<std::uint16_t> cells(std::size_t(instance.columns) * std::size_t(instance.rows));
    MACULA_TRY_VOID(reader.read(frame.number, cells));
    unpackCells(*instance.format, {}, cells);
    const int zero = instance.format->isSigned ? 32768 : 0;
    PlanarFrame loaded{.columns = instance.columns, .rows = instance.rows, .values = {}, .rgb = {}};
    loaded.rgb.reserve(3 * cells.size());
    for (const std::uint16_t cell : cells) {
        const auto& colour = (*header.palette)(cell - zero);
        loaded.rgb.insert(loaded.rgb.end(), colour.begin(), colour.end());
    }
    return loaded;
}

Result<PlanarFrame> load(const Stack& stack, std::size_t at, const PlanarHeader& header,
                         const CancelToken& cancel) {
    const Frame& frame = stack.frames[at];
    const Instance& instance = *frame.instance;
    const bool isGrey = instance.photometricInterpretation.starts_with("MONOCHROME");
    if (isGrey && instance.samplesPerPixel == 1) {
        MACULA_TRY(LoadedFrame loaded, loadFrame(stack, at, cancel));
        return PlanarFrame{
            .columns = loaded.columns, .rows = loaded.rows, .values = std::move(loaded.values), .rgb = {}};
    }
    if (!instance.format || instance.columns < 1 || instance.rows < 1 || instance.columns > kMostRows ||
        instance.rows > kMostRows)
        return colourNotUsable(instance);
    constexpr std::uint64_t kBytesOfPixel = 3 * (2 * sizeof(std::uint16_t) + sizeof(std::uint8_t));
    const std::uint64_t bytes =
        kBytesOfPixel * std::uint64_t(instance.columns) * std::uint64_t(instance.rows);
    if (const auto available = availableMemory(); available && bytes > *available)
        return notEnoughMemory(bytes, *available);
    const bool hasPalette = instance.photometricInterpretation == "PALETTE COLOR";
    return hasPalette ? paletteColours(frame, header, cancel) : colours(frame, header, cancel);
}

bool isEmbedded(const OverlayPlane& plane) {
    return plane.embeddedBit > 0;
}

// An embedded plane lies in the cells of a grey frame; where these cannot be read alone, it is left out.
std::vector<OverlayMask> overlaysOver(const Frame& frame, const PlanarHeader& header,
                                      const CancelToken& cancel) {
    std::vector<OverlayMask> masks;
    for (const OverlayPlane& plane : header.overlays)
        if (auto mask = maskOf(plane, frame.number)) masks.push_back(*std::move(mask));
    const Instance& instance = *frame.instance;
    const bool hasCells = instance.format && instance.samplesPerPixel == 1 && isNarrow(*instance.format);
    if (!hasCells || std::ranges::none_of(header.overlays, isEmbedded)) return masks;
    auto reader = readerOf(instance, false, cancel);
    std::vector<std::uint16_t> cells(std::size_t(instance.columns) * std::size_t(instance.rows));
    if (!reader || !reader->read(frame.number, cells)) return masks;
    for (const OverlayPlane& plane : header.overlays)
        if (isEmbedded(plane)) masks.push_back(embeddedMaskOf(plane, instance.columns, cells));
    std::ranges::stable_sort(masks, {}, &OverlayMask::group);
    return masks;
}

}  // namespace

Result<PlanarFrame> loadPlanarFrame(const Stack& stack, std::size_t frame, const PlanarHeader& header,
                                    const CancelToken& cancel) {
    MACULA_CHECK(frame < stack.frames.size());
    try {
        MACULA_TRY(PlanarFrame loaded, load(stack, frame, header, cancel));
        loaded.overlays = overlaysOver(stack.frames[frame], header, cancel);
        return loaded;
    } catch (const std::exception& thrown) {
        return errorOf(thrown, Text("decode the image"));
    }
}

}  // namespace macula::dicom
