#include "synthetic_manifest.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace macula::dicom::test {

namespace {

void putIfAny(DcmItem& item, const DcmTagKey& tag, const std::string& value) {
    if (!value.empty()) put(item, tag, value);
}

}  // namespace

void writeManifest(const std::filesystem::path& file, const SyntheticManifest& manifest) {
    Shell shell{.sopClassUid = "1.2.840.10008.5.1.4.1.1.88.59",
                .modality = "KO",
                .sopInstanceUid = "2.25.6000",
                .seriesUid = "2.25.6001",
                .edits = {}};
    shell.edits.push_back([&manifest](DcmItem& item) {
        put(item, DCM_PatientName, manifest.patientName);
        put(item, DCM_PatientID, manifest.patientId);
        put(item, DCM_ValueType, "CONTAINER");
        DcmItem& title = nested(item, DCM_ConceptNameCodeSequence);
        put(title, DCM_CodeValue, manifest.code);
        put(title, DCM_CodingSchemeDesignator, manifest.scheme);
        put(title, DCM_CodeMeaning, "Manifest");
        for (const SyntheticManifest::Series& each : manifest.series) {
            DcmItem& study = appended(item, DCM_CurrentRequestedProcedureEvidenceSequence);
            put(study, DCM_StudyInstanceUID, each.studyUid);
            DcmItem& series = appended(study, DCM_ReferencedSeriesSequence);
            put(series, DCM_SeriesInstanceUID, each.seriesUid);
            putIfAny(series, DCM_RetrieveURL, each.url);
            putIfAny(series, DCM_RetrieveAETitle, each.aeTitle);
            putIfAny(series, DcmTagKey(0x0040, 0xE011), each.location);
            if (!each.wadoUrl.empty())
                put(nested(series, DcmTagKey(0x0040, 0xE025)), DCM_RetrieveURL, each.wadoUrl);
            for (const std::string& uid : each.instanceUids) {
                DcmItem& instance = appended(series, DCM_ReferencedSOPSequence);
                put(instance, DCM_ReferencedSOPClassUID, "1.2.840.10008.5.1.4.1.1.2");
                put(instance, DCM_ReferencedSOPInstanceUID, uid);
            }
        }
    });
    shell.edits.insert(shell.edits.end(), manifest.edits.begin(), manifest.edits.end());
    writeShell(file, shell);
}

SyntheticManifest manifestOf(const SyntheticSeries& series) {
    SyntheticManifest manifest{.patientName = series.patientName, .patientId = series.patientId};
    SyntheticManifest::Series named{.studyUid = series.studyUid, .seriesUid = series.seriesUid};
    for (const Slice& slice : slicesOf(series)) named.instanceUids.push_back(slice.sopInstanceUid);
    manifest.series = {named};
    return manifest;
}

}  // namespace macula::dicom::test
