#include "study/open/identity.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>

#include "base/parsing.h"

namespace macula::study {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

std::string joined(const std::vector<std::string>& parts, const char* separator) {
    std::string text;
    for (const std::string& part : parts) {
        if (part.empty()) continue;
        text += (text.empty() ? "" : separator) + part;
    }
    return text;
}

Text or_(const std::string& text, Text instead) {
    const std::string_view shown = trimmed(text);
    return shown.empty() ? std::move(instead) : Text::verbatim(shown);
}

// Family, given, middle, prefix, suffix: "Doe, John Quincy, Dr., MD".
std::string representationForPeople(const std::string& representation) {
    std::vector<std::string> parts = split(representation, '^');
    for (std::string& part : parts) part = trimmed(part);
    parts.resize(std::max<std::size_t>(parts.size(), 5));
    const std::string given = joined({parts[1], parts[2]}, " ");
    std::vector<std::string> shown{parts[0], given};
    shown.insert(shown.end(), parts.begin() + 3, parts.end());
    return joined(shown, ", ");
}

Text studyLine(const Identity& identity) {
    return Text::joined({or_(dateForPeople(std::string(trimmed(identity.studyDate))), Text("no study date")),
                         Text::verbatim(trimmed(identity.studyDescription))},
                        ", ");
}

Text nameLine(const Identity& identity) {
    return or_(nameForPeople(identity.patientName), Text("No patient name"));
}

}  // namespace

std::string nameForPeople(const std::string& personName) {
    std::vector<std::string> shown;
    for (const std::string& representation : split(personName, '=')) {
        const std::string text = representationForPeople(representation);
        if (std::find(shown.begin(), shown.end(), text) == shown.end()) shown.push_back(text);
    }
    return joined(shown, " = ");
}

std::string dateForPeople(const std::string& date) {
    const bool isDate = date.size() == 8 && std::all_of(date.begin(), date.end(),
                                                        [](unsigned char c) { return std::isdigit(c) != 0; });
    return isDate ? date.substr(0, 4) + "-" + date.substr(4, 2) + "-" + date.substr(6) : date;
}

std::vector<Text> linesOf(const Identity& identity) {
    if (identity.isOfNobody) return {identity.series};
    const std::string birth(trimmed(identity.birthDate));
    const std::string id(trimmed(identity.patientId));
    return {nameLine(identity),
            Text::joined({id.empty() ? Text("No patient ID") : Text("ID {}", id),
                          birth.empty() ? Text() : Text("born {}", dateForPeople(birth)),
                          Text::verbatim(trimmed(identity.sex))},
                         ", "),
            studyLine(identity), identity.series};
}

Text titleOf(const Identity& identity) {
    if (identity.isOfNobody) return identity.series;
    return Text::joined({nameLine(identity), or_(identity.patientId, Text("no patient ID")),
                         studyLine(identity), identity.series},
                        " · ");
}

}  // namespace macula::study
