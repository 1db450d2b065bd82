#include "dicom/write/plane_image.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "dicom/write/content_item.h"
#include "dicom/write/decimal_string.h"
#include "dicom/write/object_file.h"
#include "dicom/write/object_owner.h"
#include "dicom/write/uid.h"

namespace macula::dicom {

namespace {

constexpr int kLongestSide = 65535;               // Rows and Columns, VR US
constexpr std::size_t kLongestDerivation = 1024;  // VR ST
constexpr std::size_t kMostSources = 1000;
constexpr double kUnit = 1e-4;

std::string decimals(std::initializer_list<double> values) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : "\\") + decimalString(value);
    return text;
}

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Result<void> check(const PlaneSeries& series, const PlaneImage& image, const NewObject& object) {
    const auto fits = [](int side) { return side >= 1 && side <= kLongestSide; };
    const bool isPlane = isFinite(image.positionMm) && isFinite(image.rowDirection) &&
                         isFinite(image.columnDirection) &&
                         std::abs(glm::length(image.rowDirection) - 1.0) < kUnit &&
                         std::abs(glm::length(image.columnDirection) - 1.0) < kUnit &&
                         std::abs(glm::dot(image.rowDirection, image.columnDirection)) < kUnit;
    if (!fits(series.columns) || !fits(series.rows) || !isPlane || !(series.spacingMm > 0.0) ||
        image.pixels.size() != std::size_t(series.columns) * std::size_t(series.rows))
        return refusedObject(Text("A plane of that size or place cannot be written as DICOM."),
                             Text("Take 1 to {} pixels for each side.", kLongestSide));
    const auto isPrintable = [](char c) { return c >= ' ' && c <= '~' && c != '\\'; };
    if (!isPlain(series.seriesDescription) || series.derivation.size() > kLongestDerivation ||
        !std::ranges::all_of(series.derivation, isPrintable) || !isCodeString(series.modality))
        return textRefused();
    if (!isUid(series.frameOfReferenceUid) || !isUid(series.seriesInstanceUid) || !areUids(image.sources))
        return refusedObject(Text("The images of this series have no identifiers or no frame of reference, "
                                  "and what is written could not refer to them."),
                             Text("Choose another series."));
    return checkOwner(object, Text("Write the planes without patient and study."));
}

void writeGeneral(ItemWriter to, const PlaneSeries& series, const PlaneImage& image,
                  const NewObject& object) {
    const Now now;
    to.text(DCM_SeriesInstanceUID, series.seriesInstanceUid);
    to.text(DCM_InstanceNumber, std::to_string(image.number));
    to.text(DCM_Laterality, "");         // type 2C: not known of a part that may be paired
    to.text(DCM_ConversionType, "WSD");  // workstation: PS3.3 C.8.6.1
    to.text(DCM_SecondaryCaptureDeviceManufacturer, "Macula");
    to.text(DCM_SecondaryCaptureDeviceManufacturerModelName, "Macula");
    to.text(DCM_SecondaryCaptureDeviceSoftwareVersions, object.softwareVersion);
    to.text(DCM_DateOfSecondaryCapture, now.date);
    to.text(DCM_TimeOfSecondaryCapture, now.time);
    to.text(DCM_ContentDate, now.date);
    to.text(DCM_ContentTime, now.time);
    to.text(DCM_ImageType, "DERIVED\\SECONDARY\\REFORMATTED");
    to.text(DCM_DerivationDescription, series.derivation);
    writeCode(to.item(DCM_DerivationCodeSequence, 0), {"113072", "DCM", "Multiplanar reformatting"});
    to.text(DCM_BurnedInAnnotation, "NO");
    to.text(DCM_RecognizableVisualFeatures, mayShowFace(series.bodyPart, series.heightMm) ? "YES" : "NO");
    if (!series.isFromLossyImages) to.text(DCM_LossyImageCompression, "00");
}

// Where a direction leads, as PS3.3 C.7.6.1.1.1 has it: H and F for head and feet.
std::string sideOf(const glm::dvec3& direction) {
    std::string letters = orientationLetters(direction);
    std::ranges::replace(letters, 'S', 'H');
    std::ranges::replace(letters, 'I', 'F');
    return letters;
}

void writePlane(ItemWriter to, const PlaneSeries& series, const PlaneImage& image) {
    const glm::dvec3& p = image.positionMm;
    const glm::dvec3& r = image.rowDirection;
    const glm::dvec3& c = image.columnDirection;
    to.text(DCM_FrameOfReferenceUID, series.frameOfReferenceUid);
    to.text(DCM_PositionReferenceIndicator, "");
    to.text(DCM_PatientOrientation, sideOf(r) + "\\" + sideOf(c));
    to.text(DCM_ImagePositionPatient, decimals({p.x, p.y, p.z}));
    to.text(DCM_ImageOrientationPatient, decimals({r.x, r.y, r.z, c.x, c.y, c.z}));
    to.text(DCM_PixelSpacing, decimals({series.spacingMm, series.spacingMm}));
    to.text(DCM_SliceThickness, series.thicknessMm > 0.0 ? decimalString(series.thicknessMm) : "");
    if (series.stepMm) to.text(DCM_SpacingBetweenSlices, decimalString(std::abs(*series.stepMm)));
}

void writePixels(ItemWriter to, const PlaneSeries& series, const PlaneImage& image) {
    to.word(DCM_SamplesPerPixel, 1);
    to.text(DCM_PhotometricInterpretation, "MONOCHROME2");
    to.word(DCM_Rows, std::uint16_t(series.rows));
    to.word(DCM_Columns, std::uint16_t(series.columns));
    to.word(DCM_BitsAllocated, 16);
    to.word(DCM_BitsStored, 16);
    to.word(DCM_HighBit, 15);
    to.word(DCM_PixelRepresentation, 0);
    const std::uint16_t padding = 0;
    to.words(DCM_PixelPaddingValue, ItemWriter::WordVr::us, std::span(&padding, 1));
    to.text(DCM_RescaleIntercept, decimalString(series.unitsFromStored.intercept));
    to.text(DCM_RescaleSlope, decimalString(series.unitsFromStored.slope));
    to.text(DCM_RescaleType, series.isHounsfield ? "HU" : "US");
    if (series.window) {
        to.text(DCM_WindowCenter, decimalString(series.window->center));
        to.text(DCM_WindowWidth, decimalString(series.window->width));
        if (isCodeString(series.window->function)) to.text(DCM_VOILUTFunction, series.window->function);
    }
    to.words(DCM_PixelData, ItemWriter::WordVr::ow, image.pixels);
}

// PS3.3 C.7.6.1 Source Image Sequence: what it was derived from.
void writeSources(ItemWriter to, const std::vector<ReferencedImage>& sources) {
    for (std::size_t n = 0; n < std::min(sources.size(), kMostSources); ++n) {
        ItemWriter item = to.nextItem(DCM_SourceImageSequence);
        writeReference(item, sources[n]);
        writeCode(item.item(DCM_PurposeOfReferenceCodeSequence, 0),
                  {"121322", "DCM", "Source image for image processing operation"});
    }
}

}  // namespace

Result<void> writePlaneImage(const std::filesystem::path& path, const PlaneSeries& series,
                             const PlaneImage& image, const NewObject& object) {
    MACULA_TRY_VOID(check(series, image, object));
    const ObjectKind kind{.modality = series.modality,
                          .sopClassUid = UID_SecondaryCaptureImageStorage,
                          .seriesNumber = 9400,
                          .seriesDescription = series.seriesDescription};
    return writeObject(path, object, kind, [&](ItemWriter to, const InstallationKey* standIns) {
        PlaneSeries written = series;
        std::vector<ReferencedImage> sources = image.sources;
        if (standIns != nullptr) {
            written.frameOfReferenceUid = standInUid(*standIns, series.frameOfReferenceUid);
            for (ReferencedImage& each : sources)
                each.sopInstanceUid = standInUid(*standIns, each.sopInstanceUid);
        }
        writeGeneral(to, written, image, object);
        writePlane(to, written, image);
        writeSources(to, sources);
        writePixels(to, written, image);
    });
}

}  // namespace macula::dicom
