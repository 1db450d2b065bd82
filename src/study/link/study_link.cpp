#include "study/link/study_link.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/parsing.h"
#include "net/archive/file_meta.h"
#include "study/link/link_text.h"

namespace macula::study {

namespace {

constexpr std::size_t kMostBytesOfIdentifier = 64;  // a Long String (PS3.5 6.2)
constexpr std::size_t kMostBytesOfModality = 16;
constexpr std::size_t kMostStudies = 32;
constexpr std::size_t kMostRecent = 10'000;

// The parameters of a link, each of which is taken by whoever understands it.
class Parameters {
  public:
    explicit Parameters(std::vector<LinkParameter> all) : all_(std::move(all)), taken_(all_.size()) {}

    // Empty where the link does not have it.
    std::string take(std::string_view key) {
        const auto found = std::ranges::find(all_, key, &LinkParameter::key);
        if (found == all_.end()) return {};
        taken_[std::size_t(found - all_.begin())] = true;
        return found->value;
    }
    // Not the key itself, which could be the name of a patient.
    Result<void> refuseRest(const Text& known) const {
        const auto rest = std::ranges::find(taken_, false);
        if (rest == taken_.end()) return {};
        Error error = badLink(
            Text("Part {} of the link is something that Macula does not know.", rest - taken_.begin() + 1));
        error.hint = Text("Nothing was opened. Such links may have {}.", known);
        return error;
    }

  private:
    std::vector<LinkParameter> all_;
    std::vector<bool> taken_;
};

std::vector<std::string> listOf(const std::string& text) {
    std::vector<std::string> list;
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(','), rest.size());
        if (const auto each = trimmed(rest.substr(0, end)); !each.empty()) list.emplace_back(each);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return list;
}

// What an archive would read as a pattern or as a list finds other studies than were asked for (PS3.4
// C.2.2.2.4).
Result<std::string> identifier(std::string_view text) {
    text = trimmed(text);
    if (text.size() > kMostBytesOfIdentifier)
        return badLink(Text("The link holds a number or an ID that is longer than any real one."));
    if (text.find_first_of("*?\\") != std::string_view::npos)
        return badLink(Text("The link holds a wildcard, which would find other studies too."));
    return std::string(text);
}

Result<std::vector<std::string>> uidsIn(const std::string& text) {
    std::vector<std::string> uids = listOf(text);
    if (uids.size() > kMostStudies) return badLink(Text("The link names too many studies."));
    if (!std::ranges::all_of(uids, [](const std::string& uid) { return net::isUid(uid); }))
        return badLink(Text("The link names a study by something that is no UID."));
    return uids;
}

// HL7 writes an identifier with who issued it as ID^^^ISSUER (data type CX).
struct IssuedId {
    std::string id;
    std::string issuer;
};

Result<IssuedId> issuedIdOf(const std::string& text) {
    std::vector<std::string> components{std::string()};
    for (const char c : text) {
        if (c == '^') {
            components.emplace_back();
        } else {
            components.back() += c;
        }
    }
    constexpr std::size_t kIssuer = 3;
    MACULA_TRY(std::string id, identifier(components.front()));
    if (components.size() <= kIssuer) return IssuedId{std::move(id), {}};
    // NAMESPACE&UNIVERSAL&TYPE, of which the first may be empty.
    std::string_view issuer = components[kIssuer];
    if (issuer.starts_with('&')) issuer.remove_prefix(1);
    MACULA_TRY(std::string first, identifier(issuer.substr(0, issuer.find('&'))));
    return IssuedId{std::move(id), std::move(first)};
}

// 2026-11-30, as XML has it, with or without a time; or 20261130.
std::optional<std::string> dayOf(std::string_view text) {
    std::string digits;
    if (text.size() >= 10 && text[4] == '-' && text[7] == '-' && (text.size() == 10 || text[10] == 'T')) {
        digits.append(text.substr(0, 4)).append(text.substr(5, 2)).append(text.substr(8, 2));
    } else {
        digits = text;
    }
    const bool areDigits = std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
    if (digits.size() != 8 || !areDigits) return {};
    const auto number = [&](std::size_t at, std::size_t count) {
        return parseNumber<unsigned>(std::string_view(digits).substr(at, count)).value_or(0);
    };
    const std::chrono::year_month_day day(std::chrono::year(int(number(0, 4))),
                                          std::chrono::month(number(4, 2)), std::chrono::day(number(6, 2)));
    return day.ok() ? std::optional(digits) : std::nullopt;
}

Result<std::string> dayIn(Parameters& from, std::string_view key) {
    const std::string text = from.take(key);
    if (text.empty()) return std::string();
    const auto day = dayOf(text);
    if (!day) return badLink(Text("The link holds a day that is not written as 2026-11-30."));
    return *day;
}

bool hasTime(std::string_view text) {
    return text.find('T') != std::string_view::npos;
}

Result<bool> flagIn(Parameters& from, std::string_view key) {
    const std::string text = lowerCase(from.take(key));
    if (!text.empty() && text != "true" && text != "false")
        return badLink(Text("The link has a choice that is neither true nor false."));
    return text == "true";
}

void tellOfIssuer(StudyLink& link) {
    if (link.issuer.empty()) return;
    link.notDone.push_back(Text(
        "The link says who issued the patient's ID; Macula searches by the ID alone, and other hospitals "
        "may have given the same one."));
}

Result<StudyLink> openOf(Parameters from) {
    StudyLink link;
    const std::string study = from.take("study");
    const std::string accession = from.take("accession");
    const std::string patient = from.take("patient");
    MACULA_TRY(link.issuer, identifier(from.take("issuer")));
    link.archive = from.take("archive");
    MACULA_TRY_VOID(from.refuseRest(Text("study, accession, patient, issuer and archive")));
    const int given = int(!study.empty()) + int(!accession.empty()) + int(!patient.empty());
    if (given == 0) return badLink(Text("The link does not say which study it means."));
    if (given > 1)
        return badLink(Text("The link names more than one of study, accession number and patient."));
    if (!link.issuer.empty() && patient.empty())
        return badLink(Text("The link says who issued a patient's ID, and names no patient."));
    if (!study.empty()) {
        if (!net::isUid(study)) return badLink(Text("The link names a study by something that is no UID."));
        link.studyInstanceUids = {study};
    }
    if (!accession.empty()) {
        MACULA_TRY(std::string number, identifier(accession));
        link.accessionNumbers = {std::move(number)};
    }
    MACULA_TRY(link.patientId, identifier(patient));
    tellOfIssuer(link);
    return link;
}

// What both kinds of requests may say of the display. Macula has one way to show a study, all of it.
Result<void> readDisplay(Parameters& from, StudyLink& link) {
    const std::string viewer = from.take("viewerType");
    if (!viewer.empty())
        link.notDone.push_back(
            Text("The link asks for a viewer of a certain kind; Macula has only its own window."));
    MACULA_TRY(const bool isDiagnostic, flagIn(from, "diagnosticQuality"));
    if (isDiagnostic)
        link.notDone.push_back(
            Text("The link asks for a display of diagnostic quality; Macula is not for primary diagnosis."));
    MACULA_TRY(const bool isKeyImagesOnly, flagIn(from, "keyImagesOnly"));
    if (isKeyImagesOnly)
        link.notDone.push_back(Text("The link asks for key images only; Macula opens the whole study."));
    if (!from.take("additionalParameters").empty())
        link.notDone.push_back(Text("The link has additional parameters, which Macula does not know."));
    return {};
}

Result<StudyLink> studyRequestOf(Parameters from) {
    StudyLink link;
    MACULA_TRY(link.studyInstanceUids, uidsIn(from.take("studyUID")));
    bool namesIssuer = false;
    for (const std::string& each : listOf(from.take("accessionNumber"))) {
        MACULA_TRY(IssuedId issued, issuedIdOf(each));
        namesIssuer = namesIssuer || !issued.issuer.empty();
        if (!issued.id.empty()) link.accessionNumbers.push_back(std::move(issued.id));
    }
    if (link.accessionNumbers.size() > kMostStudies) return badLink(Text("The link names too many studies."));
    if (namesIssuer)
        link.notDone.push_back(
            Text("The link says who issued the accession number; Macula searches by the number alone."));
    MACULA_TRY_VOID(readDisplay(from, link));
    MACULA_TRY_VOID(from.refuseRest(
        Text("requestType, studyUID, accessionNumber, viewerType, diagnosticQuality, keyImagesOnly and "
             "additionalParameters")));
    if (link.studyInstanceUids.empty() && link.accessionNumbers.empty())
        return badLink(Text("The link does not say which study it means."));
    return link;
}

Result<StudyLink> patientRequestOf(Parameters from) {
    StudyLink link;
    MACULA_TRY(IssuedId issued, issuedIdOf(from.take("patientID")));
    link.patientId = std::move(issued.id);
    link.issuer = std::move(issued.issuer);
    tellOfIssuer(link);
    MACULA_TRY(link.patientBirthDate, dayIn(from, "patientBirthDate"));
    if (!from.take("patientName").empty())
        link.notDone.push_back(
            Text("The link names the patient; Macula searches by the ID alone, so check the name yourself."));
    bool hasTimes = false;
    for (const auto& [key, day] :
         {std::pair("lowerDateTime", &StudyLink::dateFrom), std::pair("upperDateTime", &StudyLink::dateTo)}) {
        hasTimes = hasTimes || hasTime(from.take(key));
        MACULA_TRY(link.*day, dayIn(from, key));
    }
    if (hasTimes)
        link.notDone.push_back(
            Text("The link gives times of the day; Macula takes the studies of the whole days."));
    link.modalities = listOf(from.take("modalitiesInStudy"));
    for (const std::string& modality : link.modalities) {
        if (modality.size() > kMostBytesOfModality || modality.find_first_of("*?\\") != std::string::npos)
            return badLink(Text("The link names a modality that is none."));
    }
    if (const std::string most = from.take("mostRecentResults"); !most.empty()) {
        link.mostRecent = parseNumber<std::size_t>(most);
        if (!link.mostRecent || *link.mostRecent == 0 || *link.mostRecent > kMostRecent)
            return badLink(Text("The link asks for a number of recent studies that is none."));
    }
    MACULA_TRY_VOID(readDisplay(from, link));
    MACULA_TRY_VOID(from.refuseRest(
        Text("requestType, patientID, patientName, patientBirthDate, lowerDateTime, upperDateTime, "
             "mostRecentResults, modalitiesInStudy, viewerType, diagnosticQuality, keyImagesOnly and "
             "additionalParameters")));
    if (link.patientId.empty()) return badLink(Text("The link does not say which patient it means."));
    if (!link.dateFrom.empty() && !link.dateTo.empty() && link.dateFrom > link.dateTo)
        return badLink(Text("The link's first day is after its last one."));
    return link;
}

}  // namespace

Result<StudyLink> studyLinkOf(std::string_view text) {
    MACULA_TRY(LinkText link, linkTextOf(text));
    Parameters parameters(std::move(link.parameters));
    if (link.kind == LinkText::Kind::open) return openOf(std::move(parameters));
    const std::string request = parameters.take("requestType");
    if (request == "STUDY") return studyRequestOf(std::move(parameters));
    if (request == "PATIENT") return patientRequestOf(std::move(parameters));
    return badLink(Text("The link's requestType is neither STUDY nor PATIENT."));
}

}  // namespace macula::study
