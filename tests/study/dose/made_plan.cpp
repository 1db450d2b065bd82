#include "study/dose/made_plan.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "base/frames.h"
#include "dicom/synthetic.h"

namespace macula::study::test {

namespace {

using dicom::test::put;

constexpr const char* kPlanUid = "2.25.7001";

DcmItem& item(DcmItem& in, const DcmTagKey& sequence, long place) {
    DcmItem* made = nullptr;
    in.findOrCreateSequenceItem(sequence, made, place);
    return *made;
}

void writeImages(const std::filesystem::path& folder) {
    dicom::test::SyntheticSeries series;
    series.size = {20, 20, 10};
    series.worldFromVoxel = affine({2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {-20, -20, -10});
    series.rawInstead = [](const dicom::test::Slice&, int i, int j) { return 1024 + 10 * i + j; };
    dicom::test::writeFiles(folder, series);
}

void writeDose(const std::filesystem::path& file, const MadePlan& plan) {
    dicom::test::SyntheticSeries series;
    series.modality = "RTDOSE";
    series.sopClassUid = UID_RTDoseStorage;
    series.seriesUid = "2.25.1003";
    series.number = 2;
    series.frameOfReferenceUid = plan.frameOfReferenceUid;
    series.writeRescale = false;
    series.intercept = 0.0;
    series.slope = 0.01;
    series.size = {12, 12, 8};
    series.worldFromVoxel = affine({4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {-24, -24, -14});
    series.rawInstead = [](const dicom::test::Slice&, int i, int) { return 400 * i; };
    std::string offsets;
    for (int k = 0; k < 8; ++k)
        offsets += fmt::format("{}{}", k > 0 ? "\\" : "", 4 * k + (plan.absoluteOffsets ? -14 : 0));
    dicom::test::writeMultiFrame(file, series, slicesOf(series),
                                 {.functionalGroups = false,
                                  .dimensions = false,
                                  .edits = {[&](DcmItem& data) {
                                      put(data, DCM_PixelSpacing, "4\\4");
                                      put(data, DCM_ImagePositionPatient, "-24\\-24\\-14");
                                      put(data, DCM_ImageOrientationPatient, "1\\0\\0\\0\\1\\0");
                                      put(data, DCM_GridFrameOffsetVector, offsets);
                                      put(data, DCM_DoseUnits, plan.units);
                                      put(data, DCM_DoseType, "PHYSICAL");
                                      put(data, DCM_DoseSummationType, plan.summation);
                                      put(data, DCM_DoseGridScaling, "0.01");
                                      put(item(data, DCM_ReferencedRTPlanSequence, 0),
                                          DCM_ReferencedSOPInstanceUID, kPlanUid);
                                  }}});
}

// A rectangle in the plane z.
std::string rectangle(double x0, double x1, double z) {
    return fmt::format("{0}\\-9\\{2}\\{1}\\-9\\{2}\\{1}\\9\\{2}\\{0}\\9\\{2}", x0, x1, z);
}

void writeStructures(const std::filesystem::path& file) {
    dicom::test::Shell shell{.sopClassUid = UID_RTStructureSetStorage,
                             .modality = "RTSTRUCT",
                             .sopInstanceUid = "2.25.7002",
                             .seriesUid = "2.25.7003"};
    shell.edits.push_back([](DcmItem& data) {
        put(data, DCM_StructureSetLabel, "DRAWN");
        const std::array names{"BOX", "SIDE", "EMPTY"};
        for (std::size_t r = 0; r < names.size(); ++r) {
            DcmItem& region = item(data, DCM_StructureSetROISequence, long(r));
            put(region, DCM_ROINumber, std::to_string(r + 1));
            put(region, DCM_ReferencedFrameOfReferenceUID, "2.25.1002");
            put(region, DCM_ROIName, names[r]);
            DcmItem& drawn = item(data, DCM_ROIContourSequence, long(r));
            put(drawn, DCM_ReferencedROINumber, std::to_string(r + 1));
            put(drawn, DCM_ROIDisplayColor, r == 0 ? "255\\0\\0" : "0\\0\\255");
            if (r == 2) continue;
            for (int n = 0; n < 5; ++n) {
                DcmItem& contour = item(drawn, DCM_ContourSequence, n);
                put(contour, DCM_ContourGeometricType, "CLOSED_PLANAR");
                put(contour, DCM_NumberOfContourPoints, "4");
                put(contour, DCM_ContourData,
                    r == 0 ? rectangle(-9, 9, -4 + 2 * n) : rectangle(15, 19, -4 + 2 * n));
            }
        }
    });
    dicom::test::writeShell(file, shell);
}

void writePrescription(const std::filesystem::path& file, const std::string& prescriptions) {
    dicom::test::Shell shell{.sopClassUid = UID_RTPlanStorage,
                             .modality = "RTPLAN",
                             .sopInstanceUid = kPlanUid,
                             .seriesUid = "2.25.7004"};
    shell.edits.push_back([&](DcmItem& data) {
        long place = 0;
        for (std::size_t from = 0; from <= prescriptions.size();) {
            const std::size_t to = std::min(prescriptions.find('\\', from), prescriptions.size());
            DcmItem& reference = item(data, DCM_DoseReferenceSequence, place++);
            put(reference, DCM_DoseReferenceType, "TARGET");
            put(reference, DCM_TargetPrescriptionDose, prescriptions.substr(from, to - from));
            from = to + 1;
        }
        DcmItem& organ = item(data, DCM_DoseReferenceSequence, place);
        put(organ, DCM_DoseReferenceType, "ORGAN_AT_RISK");
        put(organ, DCM_TargetPrescriptionDose, "99");
        put(item(data, DCM_FractionGroupSequence, 0), DCM_NumberOfFractionsPlanned, "20");
    });
    dicom::test::writeShell(file, shell);
}

}  // namespace

void writePlan(const std::filesystem::path& folder, const MadePlan& plan) {
    std::filesystem::create_directories(folder);
    writeImages(folder);
    writeDose(folder / "dose.dcm", plan);
    writeStructures(folder / "structures.dcm");
    if (!plan.prescriptions.empty()) writePrescription(folder / "plan.dcm", plan.prescriptions);
}

}  // namespace macula::study::test
