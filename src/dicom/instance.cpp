#include "dicom/instance.h"

#include "dicom/transfer_syntax.h"

namespace macula::dicom {

namespace {

std::optional<CellFormat> readFormat(const Dataset& header) {
    const auto allocated = header.integer(tag::kBitsAllocated);
    const auto stored = header.integer(tag::kBitsStored);
    const auto highBit = header.integer(tag::kHighBit);
    const auto representation = header.integer(tag::kPixelRepresentation);
    if (!allocated || !stored || !highBit || !representation) return {};
    const CellFormat format{*allocated, *stored, *highBit, *representation == 1};
    if (!isUsable(format)) return {};
    return format;
}

void readPlane(const Dataset& header, Instance& instance) {
    if (const auto position = header.numbers(tag::kImagePositionPatient, 3)) {
        instance.positionMm = glm::dvec3((*position)[0], (*position)[1], (*position)[2]);
    }
    const auto orientation = header.numbers(tag::kImageOrientationPatient, 6);
    const auto spacing = header.numbers(tag::kPixelSpacing, 2);
    instance.hasPixelSpacing = spacing.has_value();
    if (!instance.positionMm || !orientation || !spacing) return;
    const std::vector<double>& o = *orientation;
    instance.plane =
        ImagePlane{.positionMm = *instance.positionMm,
                   .rowDirection = {o[0], o[1], o[2]},
                   .columnDirection = {o[3], o[4], o[5]},
                   .columnSpacingMm = (*spacing)[1],  // the first is between rows: PS3.3 10.7.1.3
                   .rowSpacingMm = (*spacing)[0]};
}

void readRescale(const Dataset& header, Instance& instance) {
    instance.slope = header.number(tag::kRescaleSlope);
    instance.intercept = header.number(tag::kRescaleIntercept);
    instance.rescaleType = header.text(tag::kRescaleType).value_or("");
    instance.rescaleInvalid = (header.has(tag::kRescaleSlope) && !instance.slope) ||
                              (header.has(tag::kRescaleIntercept) && !instance.intercept) ||
                              (instance.slope && *instance.slope == 0.0);
}

}  // namespace

Instance readInstance(const std::filesystem::path& file, const Dataset& header) {
    Instance instance;
    instance.file = file;
    instance.sopClassUid = header.text(tag::kSopClassUid).value_or("");
    instance.sopInstanceUid = header.text(tag::kSopInstanceUid).value_or("");
    instance.transferSyntaxUid = header.transferSyntaxUid();
    instance.frameOfReferenceUid = header.text(tag::kFrameOfReferenceUid).value_or("");
    instance.imageType = header.texts(tag::kImageType);
    instance.photometricInterpretation = header.text(tag::kPhotometricInterpretation).value_or("");
    instance.instanceNumber = header.integer(tag::kInstanceNumber);
    instance.columns = header.integer(tag::kColumns).value_or(0);
    instance.rows = header.integer(tag::kRows).value_or(0);
    instance.frames =
        header.integer(tag::kNumberOfFrames).value_or(1);  // absent in single-frame objects, PS3.3 C.7.6.6
    instance.samplesPerPixel = header.integer(tag::kSamplesPerPixel).value_or(1);
    instance.perFrameGeometry = header.has(tag::kPerFrameFunctionalGroups);
    instance.hasModalityLut = header.has(tag::kModalityLutSequence);
    instance.lossy = header.text(tag::kLossyImageCompression) == "01" || isLossy(instance.transferSyntaxUid);
    readPlane(header, instance);
    instance.format = readFormat(header);
    readRescale(header, instance);
    if (const auto padding = header.word(tag::kPixelPaddingValue); padding && instance.format) {
        instance.padding =
            paddingRange(*instance.format, *padding, header.word(tag::kPixelPaddingRangeLimit));
    }
    return instance;
}

SliceIntensity sliceIntensity(const Instance& instance) {
    return {.format = instance.format.value_or(CellFormat{}),
            .slope = instance.slope.value_or(1.0),
            .intercept = instance.intercept.value_or(0.0),
            .padding = instance.padding};
}

}  // namespace macula::dicom
