#include "dicom/object_owner.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <array>
#include <ctime>

#include "dicom/uid.h"

namespace macula::dicom {

namespace {

// Of the Patient and the General Study module (PS3.3 C.7.1.1, C.7.2.1), those that archives file by. Those of
// type 2 are written empty where the source has none.
struct Taken {
    DcmTagKey tag;
    bool isWrittenEmpty;
};
const std::array kTaken{Taken{DCM_SpecificCharacterSet, false},
                        Taken{DCM_PatientName, true},
                        Taken{DCM_PatientID, true},
                        Taken{DCM_IssuerOfPatientID, false},
                        Taken{DCM_PatientBirthDate, true},
                        Taken{DCM_PatientSex, true},
                        Taken{DCM_StudyInstanceUID, false},
                        Taken{DCM_StudyDate, true},
                        Taken{DCM_StudyTime, true},
                        Taken{DCM_ReferringPhysicianName, true},
                        Taken{DCM_StudyID, true},
                        Taken{DCM_AccessionNumber, true},
                        Taken{DCM_StudyDescription, false},
                        Taken{DCM_PatientAge, false}};

bool copy(DcmDataset& to, DcmDataset& from, const Taken& taken) {
    if (from.tagExists(taken.tag)) return from.findAndInsertCopyOfElement(taken.tag, &to).good();
    return !taken.isWrittenEmpty || to.insertEmptyElement(taken.tag).good();
}

}  // namespace

Now::Now() {
    const std::time_t seconds = std::time(nullptr);
    std::tm local{};
    if (localtime_r(&seconds, &local) == nullptr) return;
    date = fmt::format("{:04}{:02}{:02}", local.tm_year + 1900, local.tm_mon + 1, local.tm_mday);
    time = fmt::format("{:02}{:02}{:02}", local.tm_hour, local.tm_min, local.tm_sec);
}

Result<Origin> copyOwner(DcmDataset& to, const SecondaryCapture::Source& source) {
    const Error unreadable{ErrorCode::inputNotUsable, "The study that it belongs to cannot be read any more.",
                           source.file.string(), "Open the study again, or write it without the patient."};
    DcmFileFormat format;
    if (format
            .loadFileUntilTag(source.file.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength,
                              ERM_autoDetect, DCM_PixelData)
            .bad())
        return unreadable;
    DcmDataset& from = *format.getDataset();
    Origin origin;
    OFString value;
    if (from.findAndGetOFString(DCM_StudyInstanceUID, value).bad() || value.empty()) return unreadable;
    OFString uid;
    if (from.findAndGetOFString(DCM_SOPInstanceUID, uid).bad() || uid != source.sopInstanceUid.c_str())
        return unreadable;
    for (const Taken& taken : kTaken) {
        if (!copy(to, from, taken))
            return Error{
                ErrorCode::outputNotWritable, "The DICOM file could not be made.", {}, "Check memory."};
    }
    if (from.findAndGetOFString(DCM_Modality, value).good() && !value.empty())
        origin.modality = value.c_str();
    if (from.findAndGetOFString(DCM_SOPClassUID, value).good()) origin.sopClassUid = value.c_str();
    origin.sopInstanceUid = uid.c_str();
    return origin;
}

bool writeNobody(DcmDataset& to, bool isDeidentified) {
    bool ok = true;
    const auto text = [&](const DcmTagKey& tag, const std::string& value) {
        ok = ok && to.putAndInsertString(tag, value.c_str()).good();
    };
    text(DCM_SpecificCharacterSet, "ISO_IR 192");
    text(DCM_PatientName, isDeidentified ? "ANONYMOUS" : "PHANTOM^MACULA");
    text(DCM_PatientID, isDeidentified ? "ANONYMOUS" : "MACULA-PHANTOM");
    for (const DcmTagKey& tag : {DCM_PatientBirthDate, DCM_PatientSex, DCM_StudyDate, DCM_StudyTime,
                                 DCM_ReferringPhysicianName, DCM_StudyID, DCM_AccessionNumber})
        text(tag, "");
    text(DCM_StudyInstanceUID, newUid());
    if (!isDeidentified) return ok;
    text(DCM_PatientIdentityRemoved, "YES");
    text(DCM_DeidentificationMethod, "Macula: patient, study and all UIDs replaced");
    return ok;
}

}  // namespace macula::dicom
