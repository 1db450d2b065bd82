#include "dicom/write/object_owner.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <map>
#include <mutex>
#include <random>
#include <utility>

#include "base/sha256.h"
#include "dicom/read/patient.h"
#include "dicom/write/uid.h"

namespace macula::dicom {

namespace {

// Elements of the Patient and General Study modules (PS3.3 C.7.1.1, C.7.2.1) by which archives file objects.
// Those of type 2 are written empty if the source has none.
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

std::string textOf(DcmDataset& from, const DcmTagKey& tag) {
    OFString value;
    return from.findAndGetOFString(tag, value).good() ? value.c_str() : "";
}

// Whether the file exists, holds that instance, and names its study.
bool isRead(DcmFileFormat& format, const SecondaryCapture::Source& source) {
    const bool isThere = format
                             .loadFileUntilTag(source.file.c_str(), EXS_Unknown, EGL_noChange,
                                               DCM_MaxReadLength, ERM_autoDetect, DCM_PixelData)
                             .good();
    if (!isThere) return false;
    DcmDataset& from = *format.getDataset();
    return !textOf(from, DCM_StudyInstanceUID).empty() &&
           textOf(from, DCM_SOPInstanceUID) == source.sopInstanceUid;
}

Origin kindOf(DcmDataset& from) {
    Origin origin;
    if (std::string modality = textOf(from, DCM_Modality); !modality.empty())
        origin.modality = std::move(modality);
    origin.bodyPart = textOf(from, DCM_BodyPartExamined);
    return origin;
}

bool writeWithoutPatient(DcmDataset& to, const char* name, const Pseudonym& pseudonym) {
    bool ok = true;
    const auto text = [&](const DcmTagKey& tag, const std::string& value) {
        ok = ok && to.putAndInsertString(tag, value.c_str()).good();
    };
    text(DCM_SpecificCharacterSet, "ISO_IR 192");
    text(DCM_PatientName, name);
    text(DCM_PatientID, pseudonym.patientId);
    for (const DcmTagKey& tag : {DCM_PatientBirthDate, DCM_PatientSex, DCM_StudyDate, DCM_StudyTime,
                                 DCM_ReferringPhysicianName, DCM_StudyID, DCM_AccessionNumber})
        text(tag, "");
    text(DCM_StudyInstanceUID, pseudonym.studyInstanceUid);
    return ok;
}

std::string chance128() {
    std::random_device chance;  // 32 bits a call, from the system
    std::string digits;
    for (int i = 0; i < 4; ++i) digits += fmt::format("{:08x}", chance());
    return digits;
}

// Keeps digests under a key of this run, so that a memory dump lists no patients.
class Pseudonyms {
  public:
    Pseudonym of(const PatientIdentity& patient, const std::string& study) {
        // Each with its length, so that no two values can be mistaken for one.
        std::string who = patient.isOfNobody() ? "study " + study : std::string("patient");
        if (!patient.isOfNobody())
            for (const std::string* text : {&patient.id, &patient.name, &patient.birthDate, &patient.sex})
                who += fmt::format(" {}:{}", text->size(), *text);
        const std::lock_guard lock(mutex_);
        Pseudonym found;
        found.patientId = patients_.try_emplace(digestOf(who), "MACULA-" + chance128()).first->second;
        found.studyInstanceUid = studies_.try_emplace(digestOf(who + " in " + study), newUid()).first->second;
        return found;
    }

  private:
    std::string digestOf(const std::string& text) const { return sha256Hex(key_ + text); }

    const std::string key_ = chance128();
    std::mutex mutex_;
    std::map<std::string, std::string> patients_;
    std::map<std::string, std::string> studies_;
};

// From the diaphragm to the feet (PS3.16 L). Without hands and arms, which are held over the head, and
// without the chest, whose uppermost slices may show the chin.
constexpr std::array<std::string_view, 26> kBelowTheChest{
    "ABDOMEN", "ABDOMENPELVIS", "ANKLE",  "BLADDER", "CALF",     "COCCYX", "COLON",    "FOOT",   "HIP",
    "KIDNEY",  "KNEE",          "LEG",    "LIVER",   "LOWERLEG", "LSPINE", "PANCREAS", "PELVIS", "PROSTATE",
    "RECTUM",  "SACRUM",        "SPLEEN", "SSPINE",  "THIGH",    "TOE",    "UPPERLEG", "UTERUS"};

constexpr double kHighestMm = 600.0;  // a tall patient from the diaphragm to the thigh

}  // namespace

Now::Now() {
    const std::time_t seconds = std::time(nullptr);
    std::tm local{};
    if (localtime_r(&seconds, &local) == nullptr) return;
    date = fmt::format("{:04}{:02}{:02}", local.tm_year + 1900, local.tm_mon + 1, local.tm_mday);
    time = fmt::format("{:02}{:02}{:02}", local.tm_hour, local.tm_min, local.tm_sec);
}

Result<Origin> copyOwner(DcmDataset& to, const SecondaryCapture::Source& source) {
    const Error unreadable{
        ErrorCode::inputNotUsable, Text("The study that it belongs to cannot be read any more."),
        source.file.string(), Text("Open the study again, or write it without the patient.")};
    DcmFileFormat format;
    if (!isRead(format, source)) return unreadable;
    DcmDataset& from = *format.getDataset();
    for (const Taken& taken : kTaken) {
        if (!copy(to, from, taken))
            return Error{ErrorCode::outputNotWritable,
                         Text("The DICOM file could not be made."),
                         {},
                         Text("Check memory.")};
    }
    Origin origin = kindOf(from);
    origin.sopClassUid = textOf(from, DCM_SOPClassUID);
    origin.sopInstanceUid = source.sopInstanceUid;
    return origin;
}

bool writeNobody(DcmDataset& to) {
    return writeWithoutPatient(to, "PHANTOM^MACULA",
                               {.patientId = "MACULA-PHANTOM", .studyInstanceUid = newUid()});
}

std::optional<Origin> writePseudonym(DcmDataset& to, const std::optional<SecondaryCapture::Source>& source) {
    Origin origin;
    Pseudonym pseudonym;
    DcmFileFormat format;
    if (source && isRead(format, *source)) {
        DcmDataset& from = *format.getDataset();
        origin.bodyPart = textOf(from, DCM_BodyPartExamined);
        const PatientIdentity patient{.id = textOf(from, DCM_PatientID),
                                      .name = normalisedName(textOf(from, DCM_PatientName)),
                                      .birthDate = textOf(from, DCM_PatientBirthDate),
                                      .sex = textOf(from, DCM_PatientSex)};
        pseudonym = pseudonymOf(patient, textOf(from, DCM_StudyInstanceUID));
    } else {
        pseudonym = newPseudonym();
    }
    if (!writeWithoutPatient(to, "ANONYMOUS", pseudonym) ||
        to.putAndInsertString(DCM_PatientIdentityRemoved, "YES").bad() ||
        to.putAndInsertString(DCM_DeidentificationMethod, "Macula: patient, study and all UIDs replaced")
            .bad())
        return std::nullopt;
    return origin;
}

Pseudonym pseudonymOf(const PatientIdentity& patient, const std::string& studyInstanceUid) {
    static Pseudonyms ofThisRun;
    return ofThisRun.of(patient, studyInstanceUid);
}

Pseudonym newPseudonym() {
    return {.patientId = "MACULA-" + chance128(), .studyInstanceUid = newUid()};
}

bool mayShowFace(std::string_view bodyPart, std::optional<double> heightMm) {
    std::string part;
    for (const char c : bodyPart) {
        if (c >= 'a' && c <= 'z') part += char(c - 'a' + 'A');
        if (c >= 'A' && c <= 'Z') part += c;
    }
    const bool isBelow = std::ranges::find(kBelowTheChest, part) != kBelowTheChest.end();
    return !isBelow || !heightMm || !(*heightMm > 0.0 && *heightMm <= kHighestMm);
}

}  // namespace macula::dicom
