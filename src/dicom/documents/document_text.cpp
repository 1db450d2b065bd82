#include "dicom/documents/document_text.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

#include "dicom/documents/document_values.h"

namespace macula::dicom {

namespace {

// Each line of a text behind the same indent.
void addIndented(std::string& to, std::string_view text, std::size_t indent) {
    while (true) {
        const std::size_t end = text.find('\n');
        to.append(indent, ' ');
        to += text.substr(0, end);
        to += '\n';
        if (end == std::string_view::npos) return;
        text.remove_prefix(end + 1);
    }
}

}  // namespace

Text titleLineOf(const StudyDocument& document) {
    return document.title.empty() ? document.kindName : Text("{}: {}", document.kindName, document.title);
}

Text patientLineOf(const StudyDocument& document) {
    std::vector<Text> parts;
    const std::string name = personOf(document.patientName);
    if (!name.empty()) parts.push_back(Text::verbatim(name));
    if (const std::string id = inLines(document.patient.id); !id.empty()) parts.push_back(Text("ID {}", id));
    if (const std::string born = dateOf(document.patient.birthDate); !born.empty())
        parts.push_back(Text("born {}", born));
    if (const std::string sex = inLines(document.patient.sex); !sex.empty())
        parts.push_back(Text::verbatim(sex));
    if (name.empty() && document.patient.id.empty())
        parts.insert(parts.begin(), Text("The document names no patient."));
    return Text::joined(std::move(parts), ", ");
}

Text dateLineOf(const StudyDocument& document) {
    const std::string date = dateOf(document.date);
    const std::string time = timeOf(document.time);
    if (date.empty()) return Text("The document has no date.");
    return Text::verbatim(time.empty() ? date : fmt::format("{}, {}", date, time));
}

Text contentsLineOf(const StudyDocument& document) {
    if (!document.contents) return {};
    constexpr double kBytesOfKb = 1000.0;
    const std::string& mime = document.contents->mimeType;
    const std::string kind = mime == "application/pdf" ? "PDF" : mime.empty() ? "?" : mime;
    return Text("A file: {}, {:.1f} kB", kind, double(document.contents->bytes) / kBytesOfKb);
}

Text headingOf(const DocumentEntry& entry) {
    if (entry.relation != DocumentRelation::inferredFrom) return entry.heading;
    return entry.heading.empty() ? Text("Inferred from") : Text("Inferred from: {}", entry.heading);
}

std::string plainTextOf(const StudyDocument& document, const SayText& say,
                        const std::function<std::string(const DocumentReference&)>& nameReference) {
    constexpr std::size_t kIndent = 2;
    std::string text;
    for (const Text& line : {titleLineOf(document), patientLineOf(document), dateLineOf(document)})
        addIndented(text, say(line), 0);
    for (const Text& line : document.status) addIndented(text, say(line), 0);
    if (const Text line = contentsLineOf(document); !line.empty()) addIndented(text, say(line), 0);
    for (const Text& note : document.notes) addIndented(text, say(Text("Note: {}", note)), 0);
    if (!document.entries.empty()) text += '\n';
    for (const DocumentEntry& entry : document.entries) {
        const std::string heading = say(headingOf(entry));
        std::string value = say(entry.value);
        if (nameReference && !entry.references.empty()) {
            const std::string where = nameReference(entry.references.front());
            if (!where.empty()) value += fmt::format(" ({})", where);
        }
        const std::size_t indent = kIndent * std::size_t(entry.depth);
        const bool isLong = value.find('\n') != std::string::npos;
        if (heading.empty() || value.empty() || isLong) {
            if (!heading.empty()) addIndented(text, heading + ":", indent);
            if (!value.empty()) addIndented(text, value, heading.empty() ? indent : indent + kIndent);
            if (heading.empty() && value.empty()) addIndented(text, say(Text("(no heading)")), indent);
        } else {
            addIndented(text, fmt::format("{}: {}", heading, value), indent);
        }
    }
    return text;
}

}  // namespace macula::dicom
