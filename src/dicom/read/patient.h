// Who an image is of, as far as that keeps patients apart.
#pragma once

#include <compare>
#include <string>

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
};

PatientIdentity patientIdentity(const Dataset& header);

// "DOE^JOHN^^^ =…" and "Doe^John" are one name. Exposed for tests.
std::string normalisedName(std::string_view name);

}  // namespace macula::dicom
