#include "dicom/stack/frame_parts.h"

#include <algorithm>
#include <array>
#include <limits>

#include "dicom/read/sop_class.h"

namespace macula::dicom {

namespace {

struct Mapping {
    double slope;
    double intercept;
    std::string unit;  // UCUM code
};

// The real world value mapping, for PET and parametric maps only (PS3.3 A.75): there it gives the meaning of
// the values, elsewhere it is for display. Uses only a mapping in the unit of the image, or the first if the
// image names no unit.
std::optional<Mapping> realWorldMapping(const Dataset& dataset) {
    if (dataset.text(tag::kModality) != "PT" && dataset.text(tag::kSopClassUid) != sop_class::kParametricMap)
        return {};
    const std::string units = dataset.text(tag::kUnits).value_or("");
    for (const Dataset& item : dataset.items(tag::kRealWorldValueMapping)) {
        const auto slope = item.number(tag::kRealWorldValueSlope);
        const auto intercept = item.number(tag::kRealWorldValueIntercept);
        if (!slope || !intercept || *slope == 0.0) continue;  // a table, which is for display
        const auto codes = item.items(tag::kMeasurementUnitsCode);
        const std::string unit = codes.empty() ? "" : codes.front().shortText(tag::kCodeValue);
        const bool fits = units == "BQML"  ? unit == "Bq/ml" || unit == "Bq/mL"
                          : units == "GML" ? unit.starts_with("g/m")
                                           : units.empty() && !unit.empty();
        if (fits) return Mapping{*slope, *intercept, unit};
    }
    return {};
}

void readRescale(const Dataset& dataset, Frame& frame) {
    frame.slope = dataset.number(tag::kRescaleSlope);
    frame.intercept = dataset.number(tag::kRescaleIntercept);
    frame.rescaleType = dataset.shortText(tag::kRescaleType);
    frame.units = dataset.shortText(tag::kUnits);
    if (const auto scaling = dataset.number(tag::kDoseGridScaling)) {  // RT Dose: PS3.3 C.8.8.3
        frame.slope = *scaling;
        frame.intercept = 0.0;
        frame.rescaleType = dataset.shortText(tag::kDoseUnits);
    }
    if (const auto mapping = realWorldMapping(dataset)) {
        frame.realWorld = frame.slope != mapping->slope || frame.intercept != mapping->intercept;
        frame.slope = mapping->slope;
        frame.intercept = mapping->intercept;
        if (frame.realWorld) frame.rescaleType = mapping->unit;
        return;
    }
    frame.rescaleInvalid = (dataset.has(tag::kRescaleSlope) && !frame.slope) ||
                           (dataset.has(tag::kRescaleIntercept) && !frame.intercept) ||
                           (frame.slope && *frame.slope == 0.0);
}

void readLut(const Dataset& dataset, Frame& frame) {
    const auto items = dataset.items(tag::kModalityLutSequence);
    if (items.empty()) return;
    const auto descriptor = items.front().words(tag::kLutDescriptor);
    if (descriptor.size() == 3 && frame.instance->format) {
        frame.modalityLut =
            readModalityLut(std::array<std::uint16_t, 3>{descriptor[0], descriptor[1], descriptor[2]},
                            items.front().words(tag::kLutData), frame.instance->format->isSigned);
        frame.rescaleType = items.front().shortText(tag::kModalityLutType);
    }
    frame.modalityLutInvalid = frame.modalityLut == nullptr;
}

void readPadding(const Dataset& dataset, Frame& frame) {
    if (!frame.instance->format) return;
    const CellFormat& format = *frame.instance->format;
    if (format.kind == CellKind::integer) {
        if (const auto value = dataset.word(tag::kPixelPaddingValue)) {
            frame.padding = paddingRange(format, *value, dataset.word(tag::kPixelPaddingRangeLimit));
        }
        return;
    }
    const bool isDouble = format.kind == CellKind::float64;
    const auto value =
        dataset.number(isDouble ? tag::kDoubleFloatPixelPaddingValue : tag::kFloatPixelPaddingValue);
    if (!value) return;
    const double limit =
        dataset.number(isDouble ? tag::kDoubleFloatPixelPaddingRangeLimit : tag::kFloatPixelPaddingRangeLimit)
            .value_or(*value);
    frame.floatPadding = ValueRange{std::min(*value, limit), std::max(*value, limit)};
}

// Several pairs of centre and width, each perhaps with an explanation. Half a pair, a width of less than 1
// for LINEAR (C.11.2.1.2), and lookup tables are left out; the others are kept.
void readWindows(const Dataset& dataset, Frame& frame) {
    const auto centers = dataset.shortNumbers(tag::kWindowCenter);
    const auto widths = dataset.shortNumbers(tag::kWindowWidth);
    const auto explanations = dataset.shortTexts(tag::kWindowExplanation);
    const std::string function = dataset.shortText(tag::kVoiLutFunction);
    const double leastWidth =
        function.empty() || function == "LINEAR" ? 1.0 : std::numeric_limits<double>::min();
    const bool present = dataset.has(tag::kWindowCenter) || dataset.has(tag::kWindowWidth);
    frame.hasDisplayTable = dataset.has(tag::kVoiLutSequence);
    frame.windowInvalid = present && (centers.empty() || centers.size() != widths.size());
    constexpr std::size_t kMostWindows = 16;
    for (std::size_t i = 0; i < std::min<std::size_t>({centers.size(), widths.size(), kMostWindows}); ++i) {
        if (!(widths[i] >= leastWidth)) {
            frame.windowInvalid = true;
            continue;
        }
        frame.windows.push_back({.center = centers[i],
                                 .width = widths[i],
                                 .explanation = i < explanations.size() ? explanations[i] : "",
                                 .function = function});
    }
}

}  // namespace

void readValues(const Dataset& dataset, Frame& frame) {
    readRescale(dataset, frame);
    readLut(dataset, frame);
    readPadding(dataset, frame);
    readWindows(dataset, frame);
}

}  // namespace macula::dicom
