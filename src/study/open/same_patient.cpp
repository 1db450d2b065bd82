#include "study/open/same_patient.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/parsing.h"
#include "dicom/read/patient.h"
#include "dicom/read/placeholder.h"

namespace macula::study {

namespace {

struct Attribute {
    const char* name;
    std::string a;
    std::string b;

    bool differs() const { return !a.empty() && !b.empty() && a != b; }
};

std::string plain(const std::string& text) {
    return std::string(trimmed(text));
}

std::string date(const std::string& text) {
    std::string digits = plain(text);
    std::erase(digits, '.');  // 2000.01.01, from before DICOM 3.0: PS3.5 6.2, note to DA
    return digits;
}

std::string sex(const std::string& text) {
    std::string letter = plain(text);
    std::ranges::transform(letter, letter.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
    // DICOM has only these values (PS3.3 C.7.1.1); "U" and "N" are written for an unknown sex.
    return letter == "M" || letter == "F" || letter == "O" ? letter : std::string();
}

// Empty for a placeholder.
std::string known(std::string text) {
    return dicom::isPlaceholder(text) ? std::string() : text;
}

std::string birthDate(const std::string& text) {
    return dicom::isPlaceholderDate(text) ? std::string() : date(text);
}

std::string name(const std::string& text) {
    return known(dicom::normalisedName(plain(text)));
}

std::array<Attribute, 4> attributesOf(const Identity& a, const Identity& b) {
    return {{{"ID", known(plain(a.patientId)), known(plain(b.patientId))},
             {"name", name(a.patientName), name(b.patientName)},
             {"date of birth", birthDate(a.birthDate), birthDate(b.birthDate)},
             {"sex", sex(a.sex), sex(b.sex)}}};
}

}  // namespace

std::string studyDay(const Identity& identity) {
    std::string day = date(identity.studyDate);
    const bool isDay =
        day.size() == 8 && std::ranges::all_of(day, [](unsigned char c) { return std::isdigit(c) != 0; });
    return isDay ? day : std::string();
}

SamePatient samePatient(const Identity& a, const Identity& b) {
    if (a.isOfNobody && b.isOfNobody) return SamePatient::yes;
    if (!whatDiffers(a, b).empty()) return SamePatient::no;
    if (!a.studyInstanceUid.empty() && a.studyInstanceUid == b.studyInstanceUid) return SamePatient::yes;
    const auto attributes = attributesOf(a, b);
    const bool agree = std::ranges::all_of(
        attributes, [](const Attribute& attribute) { return attribute.a == attribute.b; });
    const bool isNamed = !attributes[0].a.empty() || !attributes[1].a.empty();
    return agree && isNamed ? SamePatient::yes : SamePatient::unknown;
}

std::vector<std::string> whatDiffers(const Identity& a, const Identity& b) {
    std::vector<std::string> names;
    for (const Attribute& attribute : attributesOf(a, b))
        if (attribute.differs()) names.emplace_back(attribute.name);
    return names;
}

Age ageOf(const Identity& study, const Identity& second) {
    const std::string a = studyDay(study);
    const std::string b = studyDay(second);
    if (a.empty() || b.empty()) return Age::unknown;
    if (a == b) return Age::sameDay;
    return b < a ? Age::earlier : Age::later;
}

}  // namespace macula::study
