#include "study/planar/planar_display.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/check.h"
#include "slices/grey.h"

namespace macula::study {

namespace {

constexpr int kWhite = 255;

// From the value below which `hundredth` of 100 lie to the one above which as many do.
DisplayWindow rangeOf(const std::vector<float>& values, std::size_t hundredth) {
    std::vector<float> known;
    known.reserve(values.size());
    std::ranges::copy_if(values, std::back_inserter(known), [](float value) { return std::isfinite(value); });
    DisplayWindow window{.center = 0.0, .width = 1.0, .explanation = {}, .function = "LINEAR_EXACT"};
    if (known.empty()) return window;
    const auto valueAt = [&](std::size_t place) {
        const auto at = known.begin() + std::ptrdiff_t(place * (known.size() - 1) / 100);
        std::nth_element(known.begin(), at, known.end());
        return double{*at};
    };
    const double low = valueAt(hundredth);
    const double high = valueAt(100 - hundredth);
    window.center = 0.5 * (low + high);
    if (high > low) window.width = high - low;
    return window;
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
        display.window = rangeOf(pixels.values, 1);
    return display;
}

DisplayWindow wholeRange(const dicom::PlanarFrame& pixels) {
    return rangeOf(pixels.values, 0);
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
    if (!display.table) {
        picture.bytes = slices::toGrey(pixels.values, display.window, isInverted);
        return picture;
    }
    MACULA_CHECK(*display.table < header.tables.size());
    picture.bytes = greyByTable(pixels.values, header.tables[*display.table], isInverted);
    return picture;
}

}  // namespace macula::study
