#include "dicom/write/measurement_report.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "dicom/write/content_item.h"
#include "dicom/write/object_file.h"
#include "dicom/write/object_owner.h"
#include "dicom/write/uid.h"
#include "toolkit/character_set.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

constexpr const char* kReportTemplate = "1500";
constexpr const char* kGroupTemplate = "1501";
constexpr const char* kRegionTemplate = "1410";

CodedName dcm(const char* value, const char* meaning) {
    return {value, "DCM", meaning};
}

// Graphic Data is float32, in which a larger number becomes infinite. False for NaN.
bool isInFloats(double number) {
    return std::abs(number) <= double(std::numeric_limits<float>::max());
}

std::size_t fewestPointsOf(ReportedShape shape) {
    switch (shape) {
        case ReportedShape::polyline:
            return 2;
        case ReportedShape::ellipse:
            return 4;
        case ReportedShape::outline:
            return 3;
    }
    return 0;
}

bool isPlaced(const ReportedPoints& reported, std::size_t fewest, const MeasurementReport& report) {
    if (const auto* on = std::get_if<PointsOnImage>(&reported))
        return on->image < report.series.images.size() && on->pointsPx.size() >= fewest &&
               std::ranges::all_of(on->pointsPx,
                                   [](const glm::dvec2& px) { return isInFloats(px.x) && isInFloats(px.y); });
    const auto& in = std::get<PointsInSpace>(reported);
    return isUid(report.series.frameOfReferenceUid) && in.pointsMm.size() >= fewest &&
           std::ranges::all_of(in.pointsMm, [](const glm::dvec3& mm) {
               return isInFloats(mm.x) && isInFloats(mm.y) && isInFloats(mm.z);
           });
}

bool isWhole(const ReportedMeasurement& m, const MeasurementReport& report) {
    return isPlaced(m.points, fewestPointsOf(m.shape), report) &&
           (!m.second || isPlaced(*m.second, 2, report)) && !m.label.empty() && isUid(m.trackingUid) &&
           !m.numbers.empty() && std::ranges::all_of(m.numbers, [&](const ReportedNumber& n) {
               return std::isfinite(n.value) && (m.second || !n.isOfSecond);
           });
}

Result<void> check(const MeasurementReport& report, const NewObject& object) {
    if (report.measurements.empty())
        return refusedObject(Text("There are no measurements to write."),
                             Text("Measure something on a slice first."));
    const PresentedSeries& series = report.series;
    if (series.images.empty() || !isUid(series.seriesInstanceUid) || !areUids(series.images))
        return refusedObject(
            Text("A report of measurements refers to DICOM images with identifiers, and this volume has "
                 "none."),
            Text("Save the measurements as a table."));
    if (!std::ranges::all_of(report.measurements,
                             [&](const ReportedMeasurement& m) { return isWhole(m, report); }))
        return refusedObject(Text("A measurement has a point or a number that a report cannot hold."),
                             Text("Remove the measurement, or save the measurements as a table."));
    return checkOwner(object, Text("Write the measurements without patient and study."));
}

void writeDocument(ItemWriter to) {
    const Now now;
    to.emptySequence(DCM_ReferencedPerformedProcedureStepSequence);
    to.text(DCM_ContentDate, now.date);
    to.text(DCM_ContentTime, now.time);
    to.text(DCM_CompletionFlag, "COMPLETE");
    to.text(DCM_VerificationFlag, "UNVERIFIED");
    to.emptySequence(DCM_PerformedProcedureCodeSequence);
}

// PS3.3 C.17.2.3: each instance that the content refers to.
void writeEvidence(ItemWriter to, const PresentedSeries& images) {
    OFString studyInstanceUid;
    to.note(to.dcmtk().findAndGetOFString(DCM_StudyInstanceUID, studyInstanceUid));
    ItemWriter study = to.item(DCM_CurrentRequestedProcedureEvidenceSequence, 0);
    study.text(DCM_StudyInstanceUID, studyInstanceUid.c_str());
    ItemWriter series = study.item(DCM_ReferencedSeriesSequence, 0);
    series.text(DCM_SeriesInstanceUID, images.seriesInstanceUid);
    for (const ReferencedImage& image : images.images)
        writeReference(series.nextItem(DCM_ReferencedSOPSequence),
                       {image.sopClassUid, image.sopInstanceUid, {}});
}

// TID 1204, 1001 with 1004, and the procedure of TID 1500.
void writeContext(ContentItem& root, const NewObject& object) {
    root.code(Relation::hasConceptModifier, dcm("121049", "Language of Content Item and Descendants"),
              {"en", "RFC5646", "English"});
    const Relation context = Relation::hasObservationContext;
    root.code(context, dcm("121005", "Observer Type"), dcm("121007", "Device"));
    // Stands for the program, not for one computer, which nothing needs to know.
    root.uid(context, dcm("121012", "Device Observer UID"),
             uidFrom("Macula " + object.softwareVersion + " as an observer"));
    root.text(context, dcm("121013", "Device Observer Name"), "Macula " + object.softwareVersion);
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

void writePoints(ContentItem& below, Relation relation, const CodedName& name, ReportedShape shape,
                 const ReportedPoints& points, const PresentedSeries& series) {
    if (const auto* on = std::get_if<PointsOnImage>(&points)) {
        ReferencedImage image = series.images[on->image];
        image.frames.clear();
        if (on->frame > 0) image.frames.push_back(on->frame);
        below.points(relation, name, shape, *on, image);
    } else {
        below.points(relation, name, shape, std::get<PointsInSpace>(points), series.frameOfReferenceUid);
    }
}

// UTF-8, whatever it was.
std::string validated(const std::string& text) {
    return decodeText(text, "ISO_IR 192", Delimiters::none).utf8;
}

void writeMeasurement(ContentItem& all, const ReportedMeasurement& m, const PresentedSeries& series) {
    const bool isRegion = m.shape != ReportedShape::polyline;
    ContentItem group =
        all.container(dcm("125007", "Measurement Group"), isRegion ? kRegionTemplate : kGroupTemplate);
    group.text(Relation::hasObservationContext, dcm("112039", "Tracking Identifier"), validated(m.label));
    group.uid(Relation::hasObservationContext, dcm("112040", "Tracking Unique Identifier"), m.trackingUid);
    if (isRegion)
        writePoints(group, Relation::contains, dcm("111030", "Image Region"), m.shape, m.points, series);
    for (const ReportedNumber& each : m.numbers) {
        ReportedNumber written = each;
        written.unit.meaning = validated(each.unit.meaning);
        ContentItem number = group.number(written);
        if (!isRegion)
            writePoints(number, Relation::inferredFrom, dcm("121112", "Source of Measurement"), m.shape,
                        each.isOfSecond ? *m.second : m.points, series);
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
                                    const NewObject& object) {
    MACULA_TRY_VOID(check(report, object));
    const ObjectKind kind{.modality = "SR",
                          .sopClassUid = UID_Comprehensive3DSRStorage,
                          .seriesNumber = 9200,
                          .seriesDescription = "Measurements",
                          .needsUtf8 = needsUtf8(report)};
    return writeObject(path, object, kind, [&](ItemWriter to, const InstallationKey* standIns) {
        MeasurementReport written = report;
        if (standIns != nullptr) written.series = withStandIns(std::move(written.series), *standIns);
        writeDocument(to);
        writeEvidence(to, written.series);
        ContentItem root(to, dcm("126000", "Imaging Measurement Report"), kReportTemplate);
        writeContext(root, object);
        writeImageLibrary(root, written);
        ContentItem all = root.container(dcm("126010", "Imaging Measurements"));
        for (const ReportedMeasurement& m : written.measurements) writeMeasurement(all, m, written.series);
    });
}

}  // namespace macula::dicom
