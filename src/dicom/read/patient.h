// The identity of an image's patient, as far as needed to keep patients apart.
#pragma once

#include <compare>
#include <map>
#include <string>
#include <utility>

#include "dicom/read/dataset.h"

namespace macula::dicom {

// Normalised, to be compared and not to be shown. Two patients are one only when all four agree; an empty
// value is a value of its own, since "empty agrees with anything" would join two patients through a third
// file. Messages report such splits; nobody would notice a wrong join.
struct PatientIdentity {
    std::string id;
    std::string name;  // first representation (PS3.5 6.2.1), lower case in ASCII, without padding
    std::string birthDate;
    std::string sex;

    auto operator<=>(const PatientIdentity&) const = default;  // NOLINT(modernize-use-nullptr): its mistake

    // Whether both ID and name are empty or placeholders.
    bool isOfNobody() const;
};

PatientIdentity patientIdentity(const Dataset& header);

// Numbers the patients of a folder, from 0. Images that name nobody belong to one patient if they belong to
// one study (PS3.3 A.1.2), otherwise to two: two studies that both say ANONYMOUS need not belong to the same
// patient.
class PatientNumbers {
  public:
    int of(const PatientIdentity& patient, const std::string& studyInstanceUid);
    int count() const { return static_cast<int>(numbers_.size()); }
    // How many of them are studies without a name or ID: two of those may belong to one patient.
    int nameless() const { return nameless_; }

  private:
    std::map<std::pair<PatientIdentity, std::string>, int> numbers_;  // the UID only if nobody is named
    int nameless_ = 0;
};

// "DOE^JOHN^^^ =…" and "Doe^John" are one name. Exposed for tests.
std::string normalisedName(std::string_view name);

}  // namespace macula::dicom
