#include "dicom/write/measurement_report.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "base/check.h"
#include "base/installation_key.h"
#include "dicom/write/content_item.h"
#include "dicom/write/object_file.h"
#include "dicom/write/object_owner.h"
#include "dicom/write/uid.h"
#include "toolkit/character_set.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongestDescription = 64;  // VR LO
constexpr const char* kReportTemplate = "1500";
constexpr const char* kGroupTemplate = "1501";
constexpr const char* kRegionTemplate = "1410";

CodedName dcm(const char* value, const char* meaning) {
    return {value, "DCM", meaning};
}

Error refused(Text message, Text hint) {
    return {ErrorCode::usage, std::move(message), {}, std::move(hint)};
}

bool isPlain(const std::string& text) {
    return text.size() <= kLongestDescription &&
           std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~' && c != '\\'; });
}

bool isUid(const std::string& uid) {
    return !uid.empty() && uid.size() <= 64 && uid.find_first_not_of("0123456789.") == std::string::npos;
}

// Graphic Data is float32, in which a larger number becomes infinite. False for NaN.
bool isInFloats(double number) {
    return std::abs(number) <= double(std::numeric_limits<float>::max());
}

bool isWhole(const ReportedMeasurement& m, const MeasurementReport& report) {
    const std::size_t fewest = m.shape == ReportedShape::ellipse ? 4 : 2;
    const bool isPlaced = std::visit(
        [&](const auto& points) {
            if constexpr (std::is_same_v<std::decay_t<decltype(points)>, PointsOnImage>) {
                return points.image < report.series.images.size() && points.pointsPx.size() >= fewest &&
                       std::ranges::all_of(points.pointsPx, [](const glm::dvec2& px) {
                           return isInFloats(px.x) && isInFloats(px.y);
                       });
            } else {
                return isUid(report.series.frameOfReferenceUid) && points.pointsMm.size() >= fewest &&
                       std::ranges::all_of(points.pointsMm, [](const glm::dvec3& mm) {
                           return isInFloats(mm.x) && isInFloats(mm.y) && isInFloats(mm.z);
                       });
            }
        },
        m.points);
    return isPlaced && !m.label.empty() && isUid(m.trackingUid) && !m.numbers.empty() &&
           std::ranges::all_of(m.numbers, [](const ReportedNumber& n) { return std::isfinite(n.value); });
}

Result<void> check(const MeasurementReport& report, const ReportOwner& owner) {
    if (!isPlain(owner.seriesDescription) || !isPlain(owner.softwareVersion) || owner.softwareVersion.empty())
        return refused(Text("The description is too long, or has characters that it may not have."),
                       Text("Take at most 64 letters, digits and signs, without a backslash."));
    if (report.measurements.empty())
        return refused(Text("There are no measurements to write."),
                       Text("Measure something on a slice first."));
    const PresentedSeries& series = report.series;
    if (series.images.empty() || !isUid(series.seriesInstanceUid) ||
        !std::ranges::all_of(series.images, [](const ReferencedImage& image) {
            return isUid(image.sopClassUid) && isUid(image.sopInstanceUid);
        }))
        return refused(
            Text("A report of measurements refers to DICOM images with identifiers, and this volume has "
                 "none."),
            Text("Save the measurements as a table."));
    if (!std::ranges::all_of(report.measurements,
                             [&](const ReportedMeasurement& m) { return isWhole(m, report); }))
        return refused(Text("A measurement has a point or a number that a report cannot hold."),
                       Text("Remove the measurement, or save the measurements as a table."));
    if (!owner.image && !owner.isDeidentified)
        return refused(Text("The files of this study do not say which patient and which study it is."),
                       Text("Write the measurements without patient and study."));
    return {};
}

void writeSeriesAndDocument(ItemWriter to, const ReportOwner& owner) {
    const Now now;
    to.text(DCM_Modality, "SR");
    to.text(DCM_SeriesInstanceUID, newUid());
    to.text(DCM_SeriesNumber, std::to_string(owner.seriesNumber));
    to.text(DCM_SeriesDescription, owner.seriesDescription);
    to.text(DCM_SeriesDate, now.date);
    to.text(DCM_SeriesTime, now.time);
    to.emptySequence(DCM_ReferencedPerformedProcedureStepSequence);
    to.text(DCM_Manufacturer, "Macula");
    to.text(DCM_ManufacturerModelName, "Macula");
    to.text(DCM_DeviceSerialNumber, "0");  // a program has none
    to.text(DCM_SoftwareVersions, owner.softwareVersion);
    to.text(DCM_SOPClassUID, UID_Comprehensive3DSRStorage);
    to.text(DCM_SOPInstanceUID, newUid());
    to.text(DCM_InstanceCreationDate, now.date);
    to.text(DCM_InstanceCreationTime, now.time);
    to.text(DCM_InstanceNumber, "1");
    to.text(DCM_ContentDate, now.date);
    to.text(DCM_ContentTime, now.time);
    to.text(DCM_CompletionFlag, "COMPLETE");
    to.text(DCM_VerificationFlag, "UNVERIFIED");
    to.emptySequence(DCM_PerformedProcedureCodeSequence);
}

// PS3.3 C.17.2.3: each instance that the content refers to.
void writeEvidence(ItemWriter to, const PresentedSeries& images, const std::string& studyInstanceUid) {
    ItemWriter study = to.item(DCM_CurrentRequestedProcedureEvidenceSequence, 0);
    study.text(DCM_StudyInstanceUID, studyInstanceUid);
    ItemWriter series = study.item(DCM_ReferencedSeriesSequence, 0);
    series.text(DCM_SeriesInstanceUID, images.seriesInstanceUid);
    for (const ReferencedImage& image : images.images)
        writeReference(series.nextItem(DCM_ReferencedSOPSequence),
                       {image.sopClassUid, image.sopInstanceUid, {}});
}

// TID 1204, 1001 with 1004, and the procedure of TID 1500.
void writeContext(ContentItem& root, const ReportOwner& owner) {
    root.code(Relation::hasConceptModifier, dcm("121049", "Language of Content Item and Descendants"),
              {"en", "RFC5646", "English"});
    const Relation context = Relation::hasObservationContext;
    root.code(context, dcm("121005", "Observer Type"), dcm("121007", "Device"));
    // Stands for the program, not for one computer, which nothing needs to know.
    root.uid(context, dcm("121012", "Device Observer UID"),
             uidFrom("Macula " + owner.softwareVersion + " as an observer"));
    root.text(context, dcm("121013", "Device Observer Name"), "Macula " + owner.softwareVersion);
    root.text(context, dcm("121014", "Device Observer Manufacturer"), "Macula");
    root.text(context, dcm("121015", "Device Observer Model Name"), "Macula");
    root.code(Relation::hasConceptModifier, dcm("121058", "Procedure reported"),
              {"363679005", "SCT", "Imaging procedure"});
}

// TID 1600, with what of TID 1602 holds for all of the images.
void writeImageLibrary(ContentItem& root, const MeasurementReport& report) {
    ContentItem library = root.container(dcm("111028", "Image Library"), "1600");
    ContentItem group = library.container(dcm("126200", "Image Library Group"));
    for (const CodedName& modality : {dcm("CT", "Computed Tomography"), dcm("MR", "Magnetic Resonance"),
                                      dcm("PT", "Positron emission tomography")}) {
        if (modality.value == report.modality)
            group.code(Relation::hasAcquisitionContext, dcm("121139", "Modality"), modality);
    }
    if (!report.series.frameOfReferenceUid.empty())
        group.uid(Relation::hasAcquisitionContext, dcm("112227", "Frame of Reference UID"),
                  report.series.frameOfReferenceUid);
    for (const ReferencedImage& image : report.series.images)
        group.image({image.sopClassUid, image.sopInstanceUid, {}});
}

void writePoints(ContentItem& below, Relation relation, const CodedName& name, const ReportedMeasurement& m,
                 const PresentedSeries& series) {
    if (const auto* on = std::get_if<PointsOnImage>(&m.points)) {
        ReferencedImage image = series.images[on->image];
        image.frames.clear();
        if (on->frame > 0) image.frames.push_back(on->frame);
        below.points(relation, name, m.shape, *on, image);
    } else {
        below.points(relation, name, m.shape, std::get<PointsInSpace>(m.points), series.frameOfReferenceUid);
    }
}

// UTF-8, whatever it was.
std::string validated(const std::string& text) {
    return decodeText(text, "ISO_IR 192", Delimiters::none).utf8;
}

void writeMeasurement(ContentItem& all, const ReportedMeasurement& m, const PresentedSeries& series) {
    const bool isRegion = m.shape == ReportedShape::ellipse;
    ContentItem group =
        all.container(dcm("125007", "Measurement Group"), isRegion ? kRegionTemplate : kGroupTemplate);
    group.text(Relation::hasObservationContext, dcm("112039", "Tracking Identifier"), validated(m.label));
    group.uid(Relation::hasObservationContext, dcm("112040", "Tracking Unique Identifier"), m.trackingUid);
    if (isRegion) writePoints(group, Relation::contains, dcm("111030", "Image Region"), m, series);
    for (const ReportedNumber& each : m.numbers) {
        ReportedNumber written = each;
        written.unit.meaning = validated(each.unit.meaning);
        ContentItem number = group.number(written);
        if (!isRegion)
            writePoints(number, Relation::inferredFrom, dcm("121112", "Source of Measurement"), m, series);
    }
    if (!m.comment.empty()) group.text(Relation::contains, dcm("121106", "Comment"), m.comment);
}

bool needsUtf8(const MeasurementReport& report) {
    return !std::ranges::all_of(report.measurements, [](const ReportedMeasurement& m) {
        return isAscii(m.label) && std::ranges::all_of(m.numbers, [](const ReportedNumber& n) {
                   return isAscii(n.unit.meaning);
               });
    });
}

}  // namespace

Result<void> writeMeasurementReport(const fs::path& path, const MeasurementReport& report,
                                    const ReportOwner& owner) try {
    MACULA_TRY_VOID(check(report, owner));
    const QuietToolkit quiet;
    const Error failed{ErrorCode::outputNotWritable, Text("The DICOM file could not be made."), path.string(),
                       Text("Check memory.")};
    DcmFileFormat format;
    DcmDataset& dataset = *format.getDataset();
    MeasurementReport written = report;
    bool ok = true;
    if (owner.isDeidentified) {
        MACULA_TRY(const InstallationKey key, InstallationKey::ofUser());
        ok = writePseudonym(dataset, owner.image).has_value();
        written.series = withStandIns(std::move(written.series), key);
    } else if (const Result<Origin> origin = copyOwner(dataset, *owner.image); !origin) {
        return origin.error();
    }
    if (needsUtf8(written)) ok = ok && convertToUtf8(dataset);
    OFString study;
    ok = ok && dataset.findAndGetOFString(DCM_StudyInstanceUID, study).good();
    ItemWriter to(dataset, ok);
    writeSeriesAndDocument(to, owner);
    writeEvidence(to, written.series, study.c_str());
    ContentItem root(to, dcm("126000", "Imaging Measurement Report"), kReportTemplate);
    writeContext(root, owner);
    writeImageLibrary(root, written);
    ContentItem all = root.container(dcm("126010", "Imaging Measurements"));
    for (const ReportedMeasurement& m : written.measurements) writeMeasurement(all, m, written.series);
    if (!ok) return failed;
    return saveObject(path, format);
} catch (const CheckFailure&) {
    throw;  // a bug in Macula, not a fault of the file
} catch (...) {
    return Error{ErrorCode::outputNotWritable, Text("The DICOM file could not be written."), path.string(),
                 Text("Check free space and memory.")};
}

}  // namespace macula::dicom
