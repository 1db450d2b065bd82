#include "app/study/second_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <vector>

#include "app/study/carried_view.h"
#include "base/parsing.h"
#include "base/sha256.h"
#include "dicom/read/patient.h"
#include "dicom/read/placeholder.h"

namespace macula::app {

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
    std::erase(digits, '.');  // 2000.01.01, of before DICOM 3: PS3.5 6.2 note to DA
    return digits;
}

std::string sex(const std::string& text) {
    std::string letter = plain(text);
    std::ranges::transform(letter, letter.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
    // Others are no value of DICOM (PS3.3 C.7.1.1): "U" and "N" are written where nobody knows.
    return letter == "M" || letter == "F" || letter == "O" ? letter : std::string();
}

// Empty where it names nobody.
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

bool isDate(const std::string& text) {
    return text.size() == 8 &&
           std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

// Empty where no folder was read.
std::string keyOf(const OpenedStudy& study) {
    const bool isFound = study.found && study.volumeIndex < study.found->volumes().size();
    return isFound ? study.found->key(study.volumeIndex) : std::string();
}

}  // namespace

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
    const std::string a = date(study.studyDate);
    const std::string b = date(second.studyDate);
    if (!isDate(a) || !isDate(b)) return Age::unknown;
    if (a == b) return Age::sameDay;
    return b < a ? Age::earlier : Age::later;
}

PlaceInSeries placeInSeries(const OpenedStudy& study) {
    PlaceInSeries at;
    if (!study.found || study.volumeIndex >= study.found->volumes().size()) return at;
    const std::vector<FoundVolume>& volumes = study.found->volumes();
    at.count = 0;
    for (std::size_t n = 0; n < volumes.size(); ++n) {
        if (volumes[n].series != volumes[study.volumeIndex].series) continue;
        if (n == study.volumeIndex) at.place = at.count;
        ++at.count;
    }
    return at;
}

std::string plainTag(const OpenedStudy& study) {
    if (study.identity.isOfNobody) return "phantom";
    std::string tag = study.volume->modality().empty() ? "images" : study.volume->modality();
    const std::string day = date(study.identity.studyDate);
    tag += ", " + (isDate(day) ? dateForPeople(day) : std::string("no study date"));
    if (!study.found || study.volumeIndex >= study.found->volumes().size()) return tag;
    if (const auto& number = study.found->volumes()[study.volumeIndex].series->number)
        tag += fmt::format(", series {}", *number);
    if (const PlaceInSeries at = placeInSeries(study); at.count > 1)
        tag += fmt::format(", volume {} of {}", at.place + 1, at.count);
    return tag;
}

bool shareFrameOfReference(const OpenedStudy& study, const OpenedStudy& second) {
    return !study.frameOfReferenceUid.empty() && study.frameOfReferenceUid == second.frameOfReferenceUid &&
           samePatient(study.identity, second.identity) != SamePatient::no;
}

BesideState firstLink(const OpenedStudy& study, const OpenedStudy& second, const std::string& pair) {
    BesideState state;
    state.pair = pair;
    state.seriesDigest = second.seriesDigest;
    if (const PlaceInSeries at = placeInSeries(second); at.count > 1) state.volume = at.place;
    state.volumeKey = keyOf(second);
    state.linksWindow = arePhases(study, second);
    if (shareFrameOfReference(study, second)) {
        state.link = BesideLink::sameFrame;
        return state;
    }
    const glm::dvec3 shift = second.volume->worldBox().centre() - study.volume->worldBox().centre();
    state.secondFromStudy[3] = glm::dvec4(shift, 1.0);
    return state;
}

std::string pairDigest(const std::string& studyFingerprint, const std::string& secondFingerprint) {
    return sha256Hex(studyFingerprint + " " + secondFingerprint);
}

BesideState withLookOf(BesideState place, const BesideState& before) {
    const bool mayLieOver = place.isLinked() || before.view != BesideView::over;
    place.view = mayLieOver ? before.view : BesideView::beside;
    place.window = before.window;
    place.linksWindow = before.linksWindow;
    place.opacity = before.opacity;
    place.colours = before.colours;
    place.in3d = before.in3d;
    place.preset = before.preset;
    return place;
}

bool isOf(const BesideState& state, const OpenedStudy& second, const std::string& pair) {
    return !pair.empty() && state.pair == pair && names(state, second);
}

bool names(const BesideState& state, const OpenedStudy& second) {
    if (state.seriesDigest != second.seriesDigest) return false;
    if (!state.volumeKey.empty() && second.found) return keyOf(second) == state.volumeKey;
    const PlaceInSeries at = placeInSeries(second);
    return state.volume ? *state.volume == at.place : at.count == 1;
}

std::optional<std::size_t> volumeOf(const FoundVolumes& found, const BesideState& state) {
    std::vector<std::size_t> ofSeries;
    for (std::size_t n = 0; n < found.volumes().size(); ++n)
        if (sha256Hex(found.volumes()[n].series->seriesInstanceUid) == state.seriesDigest)
            ofSeries.push_back(n);
    if (!state.volumeKey.empty()) {
        const auto same =
            std::ranges::find_if(ofSeries, [&](std::size_t n) { return found.key(n) == state.volumeKey; });
        // Another one is not meant, not even the only one that is left: isOf says the same.
        return same != ofSeries.end() ? std::optional(*same) : std::nullopt;
    }
    if (!state.volume && ofSeries.size() != 1) return std::nullopt;
    const std::size_t place = state.volume.value_or(0);
    return place < ofSeries.size() ? std::optional(ofSeries[place]) : std::nullopt;
}

}  // namespace macula::app
