#include "dicom/read/patient.h"

#include <algorithm>

#include "dicom/read/placeholder.h"

namespace macula::dicom {

std::string normalisedName(std::string_view name) {
    // The first representation that is there: files in ideographic characters only may leave it empty.
    while (name.starts_with('=')) name.remove_prefix(1);
    name = name.substr(0, name.find('='));
    std::string result;
    for (const char c : name) {
        if (c == ' ' && (result.empty() || result.back() == '^' || result.back() == ' ')) continue;
        if (c == '^') {
            while (result.ends_with(' ')) result.pop_back();
        }
        // Lower case is made by hand: std::tolower asks the locale, which must not decide who is who.
        result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    while (result.ends_with('^') || result.ends_with(' ')) result.pop_back();
    return result;
}

bool PatientIdentity::isOfNobody() const {
    return isPlaceholder(id) && isPlaceholder(name);
}

int PatientNumbers::of(const PatientIdentity& patient, const std::string& studyInstanceUid) {
    const bool isOfNobody = patient.isOfNobody();
    const auto [place, isNew] =
        numbers_.try_emplace({patient, isOfNobody ? studyInstanceUid : std::string()}, count());
    if (isNew && isOfNobody) ++nameless_;
    return place->second;
}

PatientIdentity patientIdentity(const Dataset& header) {
    const auto text = [&](Tag tag) { return header.text(tag).value_or(""); };
    PatientIdentity patient{.id = text(tag::kPatientId),
                            .name = normalisedName(text(tag::kPatientName)),
                            .birthDate = text(tag::kPatientBirthDate),
                            .sex = text(tag::kPatientSex)};
    std::erase(patient.birthDate, '.');  // 2000.01.01, from before DICOM 3.0: PS3.5 6.2, note to DA
    std::transform(patient.sex.begin(), patient.sex.end(), patient.sex.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return patient;
}

}  // namespace macula::dicom
