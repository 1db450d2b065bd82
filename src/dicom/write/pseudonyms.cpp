#include "dicom/write/pseudonyms.h"

#include <fmt/format.h>

#include <map>
#include <mutex>
#include <random>

#include "base/sha256.h"
#include "dicom/write/uid.h"

namespace macula::dicom {

namespace {

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

}  // namespace

Pseudonym pseudonymOf(const PatientIdentity& patient, const std::string& studyInstanceUid) {
    static Pseudonyms ofThisRun;
    return ofThisRun.of(patient, studyInstanceUid);
}

Pseudonym newPseudonym() {
    return {.patientId = "MACULA-" + chance128(), .studyInstanceUid = newUid()};
}

}  // namespace macula::dicom
