#include "study/planar/planar_display.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "base/check.h"
#include "slices/grey.h"

namespace macula::study {

namespace {

constexpr int kWhite = 255;

// Of no values, low is above high.
DisplayWindow linearBetween(double low, double high) {
    DisplayWindow window{.center = 0.0, .width = 1.0, .explanation = {}, .function = "LINEAR_EXACT"};
    if (low > high) return window;
    window.center = 0.5 * (low + high);
    if (high > low) window.width = high - low;
    return window;
}

// From the hundredth part of the values to the last but a hundredth.
DisplayWindow usualRange(const std::vector<float>& values) {
    std::vector<float> known;
    known.reserve(values.size());
    std::ranges::copy_if(values, std::back_inserter(known), [](float value) { return std::isfinite(value); });
    if (known.empty()) return linearBetween(1.0, 0.0);
    const auto valueAt = [&](std::size_t hundredth) {
        const auto at = known.begin() + std::ptrdiff_t(hundredth * (known.size() - 1) / 100);
        std::nth_element(known.begin(), at, known.end());
        return double{*at};
    };
    const double low = valueAt(1);
    return linearBetween(low, valueAt(99));
}

std::vector<std::uint8_t> greyByTable(const std::vector<float>& values, const dicom::VoiTable& voi,
                                      bool isInverted) {
    const double most = double((1u << unsigned(voi.bits)) - 1);
    std::vector<std::uint8_t> grey;
    grey.reserve(values.size());
    for (const float value : values) {
        if (!std::isfinite(value)) {
            grey.push_back(0);
            continue;
        }
        constexpr float kFarthest = 1e9F;  // beyond any table, and within the integers
        const auto input = std::int64_t(std::lround(std::clamp(value, -kFarthest, kFarthest)));
        const double part = std::min((*voi.table)(input) / most, 1.0);
        grey.push_back(static_cast<std::uint8_t>(std::lround(kWhite * (isInverted ? 1.0 - part : part))));
    }
    return grey;
}

}  // namespace

PlanarDisplay usualDisplay(const dicom::Frame& frame, const dicom::PlanarHeader& header,
                           const dicom::PlanarFrame& pixels) {
    PlanarDisplay display;
    if (pixels.isColour()) return display;
    if (!header.tables.empty()) display.table = 0;
    // The window of a file is for rescaled values, not for those of a real world value mapping.
    if (!frame.windows.empty() && !frame.realWorld)
        display.window = frame.windows.front();
    else
        display.window = usualRange(pixels.values);
    return display;
}

// Without a copy: it is called while a person drags.
DisplayWindow wholeRange(const dicom::PlanarFrame& pixels) {
    float low = std::numeric_limits<float>::infinity();
    float high = -low;
    for (const float value : pixels.values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    return linearBetween(low, high);
}

PlanarPicture pictureOf(const dicom::PlanarFrame& pixels, const dicom::PlanarHeader& header,
                        const PlanarDisplay& display) {
    PlanarPicture picture{pixels.columns, pixels.rows, pixels.isColour(), {}};
    if (pixels.isColour()) {
        picture.bytes = pixels.rgb;
        if (display.isInverted)
            for (std::uint8_t& byte : picture.bytes) byte = static_cast<std::uint8_t>(kWhite - byte);
        return picture;
    }
    const bool isInverted = header.isLowBright != display.isInverted;
    if (display.presented) {
        picture.bytes = greyByTable(pixels.values, *display.presented, isInverted);
        return picture;
    }
    if (!display.table) {
        picture.bytes = slices::toGrey(pixels.values, display.window, isInverted);
        return picture;
    }
    MACULA_CHECK(*display.table < header.tables.size());
    picture.bytes = greyByTable(pixels.values, header.tables[*display.table], isInverted);
    return picture;
}

PlanarPicture turned(PlanarPicture picture, int quarters, bool isMirrored) {
    const std::size_t bytesOfPixel = picture.isColour ? 3 : 1;
    const auto copy = [&](const PlanarPicture& from, int fromX, int fromY, PlanarPicture& to, int x, int y) {
        const auto placeOf = [&](const PlanarPicture& of, int column, int row) {
            return of.bytes.begin() +
                   std::ptrdiff_t(bytesOfPixel *
                                  (std::size_t(row) * std::size_t(of.columns) + std::size_t(column)));
        };
        std::copy_n(placeOf(from, fromX, fromY), bytesOfPixel,
                    to.bytes.begin() + (placeOf(to, x, y) - to.bytes.begin()));
    };
    for (int quarter = 0; quarter < quarters; ++quarter) {
        PlanarPicture next{picture.rows, picture.columns, picture.isColour,
                           std::vector<std::uint8_t>(picture.bytes.size())};
        for (int y = 0; y < next.rows; ++y)
            for (int x = 0; x < next.columns; ++x) copy(picture, y, picture.rows - 1 - x, next, x, y);
        picture = std::move(next);
    }
    if (!isMirrored) return picture;
    PlanarPicture mirrored = picture;
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.columns; ++x) copy(picture, picture.columns - 1 - x, y, mirrored, x, y);
    return mirrored;
}

void addShutter(PlanarPicture& picture, const dicom::DisplayShutter& shutter, double heightOverWidth) {
    const std::size_t bytesOfPixel = picture.isColour ? 3 : 1;
    const std::vector<bool> hidden = hiddenBy(shutter, picture.columns, picture.rows, heightOverWidth);
    for (std::size_t i = 0; i < hidden.size(); ++i)
        if (hidden[i])
            std::fill_n(picture.bytes.begin() + std::ptrdiff_t(bytesOfPixel * i), bytesOfPixel, shutter.grey);
}

void addOverlay(PlanarPicture& picture, const dicom::OverlayMask& overlay) {
    const std::size_t bytesOfPixel = picture.isColour ? 3 : 1;
    // Only where both lie.
    const int left = std::max(0, overlay.origin.x - 1);
    const int top = std::max(0, overlay.origin.y - 1);
    const int right = std::min(picture.columns, overlay.origin.x - 1 + overlay.columns);
    const int bottom = std::min(picture.rows, overlay.origin.y - 1 + overlay.rows);
    for (int j = top; j < bottom; ++j)
        for (int i = left; i < right; ++i) {
            if (!overlay.marks(i, j)) continue;
            const std::size_t pixel = std::size_t(j) * std::size_t(picture.columns) + std::size_t(i);
            std::fill_n(picture.bytes.begin() + std::ptrdiff_t(bytesOfPixel * pixel), bytesOfPixel,
                        std::uint8_t{kWhite});
        }
}

}  // namespace macula::study
