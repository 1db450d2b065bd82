// Who an image is of, as far as that keeps patients apart.
#pragma once

#include <compare>
#include <map>
#include <string>
#include <utility>

#include "dicom/read/dataset.h"

namespace macula::dicom {

// Normalised, to be compared and not to be shown. Two patients are one only when all four agree; an empty
// value is a value of its own, since "empty agrees with anything" would join two patients through a third
// file. What is split this way is reported, and what is joined wrongly would not be seen.
struct PatientIdentity {
    std::string id;
    std::string name;  // first representation (PS3.5 6.2.1), lower case in ASCII, without padding
    std::string birthDate;
    std::string sex;

    auto operator<=>(const PatientIdentity&) const = default;  // NOLINT(modernize-use-nullptr): its mistake

    // Neither ID nor name say who it is: they are empty, or placeholders.
    bool isOfNobody() const;
};

PatientIdentity patientIdentity(const Dataset& header);

// Numbers the patients of a folder, from 0. Of images that name nobody those of one study are of one patient
// (PS3.3 A.1.2), and two studies are of two: that both say ANONYMOUS makes nobody the same.
class PatientNumbers {
  public:
    int of(const PatientIdentity& patient, const std::string& studyInstanceUid);
    int count() const { return static_cast<int>(numbers_.size()); }
    // How many of them are studies that name nobody: two of those may be one patient.
    int nameless() const { return nameless_; }

  private:
    std::map<std::pair<PatientIdentity, std::string>, int> numbers_;  // the UID: of nobody's alone
    int nameless_ = 0;
};

// "DOE^JOHN^^^ =…" and "Doe^John" are one name. Exposed for tests.
std::string normalisedName(std::string_view name);

}  // namespace macula::dicom
