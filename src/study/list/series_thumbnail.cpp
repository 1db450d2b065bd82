#include "study/list/series_thumbnail.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "study/planar/planar_display.h"

namespace macula::study {

namespace {

std::size_t middleOf(const dicom::Stack& stack) {
    if (stack.slices.empty()) return stack.frames.size() / 2;
    const dicom::SliceSource& middle = stack.slices[stack.slices.size() / 2];
    return middle.weight < 0.5 ? middle.below : middle.above;
}

// The luminances (ITU-R BT.601) of colours.
std::vector<std::uint8_t> greyOf(PlanarPicture picture) {
    if (!picture.isColour) return std::move(picture.bytes);
    std::vector<std::uint8_t> grey;
    grey.reserve(picture.bytes.size() / 3);
    for (std::size_t i = 0; i < picture.bytes.size(); i += 3)
        grey.push_back(static_cast<std::uint8_t>(std::lround(
            0.299 * picture.bytes[i] + 0.587 * picture.bytes[i + 1] + 0.114 * picture.bytes[i + 2])));
    return grey;
}

// How much of each old cell a new cell covers, along one axis.
struct Cover {
    std::size_t first = 0;
    std::vector<double> shares;  // their sum is 1
};

std::vector<Cover> coversOf(int from, int to) {
    std::vector<Cover> covers;
    for (int n = 0; n < to; ++n) {
        const double begin = double(n) * from / to;
        const double end = double(n + 1) * from / to;
        const int first = std::min(static_cast<int>(begin), from - 1);
        const int last = std::clamp(static_cast<int>(std::ceil(end)) - 1, first, from - 1);
        Cover cover{.first = static_cast<std::size_t>(first), .shares = {}};
        for (int cell = first; cell <= last; ++cell) {
            const double share = std::min(end, cell + 1.0) - std::max(begin, double(cell));
            cover.shares.push_back(std::max(share, 0.0) / (end - begin));
        }
        covers.push_back(std::move(cover));
    }
    return covers;
}

Result<Thumbnail> make(const dicom::Stack& stack, const CancelToken& cancel) {
    if (stack.frames.empty())
        return Error{
            ErrorCode::inputNotUsable, Text("There is no image."), {}, Text("Choose another series.")};
    const std::size_t middle = middleOf(stack);
    const dicom::Frame& frame = stack.frames[middle];
    MACULA_TRY(const dicom::PlanarHeader header, dicom::readPlanarHeader(frame.instance->file, frame.number));
    MACULA_TRY(const dicom::PlanarFrame image, dicom::loadPlanarFrame(stack, middle, header, cancel));
    const std::vector<std::uint8_t> grey =
        greyOf(pictureOf(image, header, usualDisplay(frame, header, image)));
    if (!frame.plane) return shrunk(grey, image.columns, image.rows, 1.0, header.pixelHeightOverWidth);
    return shrunk(grey, image.columns, image.rows, frame.plane->columnSpacingMm, frame.plane->rowSpacingMm);
}

}  // namespace

Thumbnail shrunk(std::span<const std::uint8_t> grey, int columns, int rows, double columnSpacingMm,
                 double rowSpacingMm) {
    MACULA_CHECK(columns > 0 && rows > 0);
    MACULA_CHECK(grey.size() == static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    const auto isLength = [](double mm) { return std::isfinite(mm) && mm > 0.0; };
    if (!isLength(columnSpacingMm) || !isLength(rowSpacingMm)) columnSpacingMm = rowSpacingMm = 1.0;
    // In units of the finer spacing. The limit keeps numbers finite: such a picture is one pixel wide or high
    // anyway.
    constexpr double kLongest = 1e12;
    const double finest = std::min(columnSpacingMm, rowSpacingMm);
    const double width = std::min(columns * (columnSpacingMm / finest), kLongest);
    const double height = std::min(rows * (rowSpacingMm / finest), kLongest);
    const double scale = std::min(1.0, kThumbnailPx / std::max(width, height));
    const auto pixels = [&](double length) {
        return static_cast<int>(std::clamp(std::round(length * scale), 1.0, double(kThumbnailPx)));
    };
    Thumbnail small{.widthPx = pixels(width), .heightPx = pixels(height), .grey = {}};

    const std::vector<Cover> across = coversOf(columns, small.widthPx);
    const std::vector<Cover> down = coversOf(rows, small.heightPx);
    small.grey.reserve(across.size() * down.size());
    std::vector<double> line(static_cast<std::size_t>(columns));
    for (const Cover& ofRows : down) {
        std::fill(line.begin(), line.end(), 0.0);
        for (std::size_t r = 0; r < ofRows.shares.size(); ++r) {
            const auto row = grey.subspan((ofRows.first + r) * line.size(), line.size());
            for (std::size_t i = 0; i < line.size(); ++i) line[i] += ofRows.shares[r] * row[i];
        }
        for (const Cover& ofColumns : across) {
            double sum = 0.0;
            for (std::size_t c = 0; c < ofColumns.shares.size(); ++c)
                sum += ofColumns.shares[c] * line[ofColumns.first + c];
            small.grey.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(sum), 0L, 255L)));
        }
    }
    return small;
}

Result<Thumbnail> thumbnailOf(const dicom::Stack& stack, const CancelToken& cancel) {
    try {
        return make(stack, cancel);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory,
                     Text("There is not enough memory for a picture of the series."),
                     {},
                     Text("Close other programs.")};
    }
}

}  // namespace macula::study
