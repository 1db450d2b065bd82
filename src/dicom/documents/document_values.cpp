#include "dicom/documents/document_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/parsing.h"
#include "base/printable.h"
#include "dicom/documents/document_tags.h"
#include "dicom/read/sop_class.h"

namespace macula::dicom {

namespace {

constexpr std::size_t kMostFrames = 1000;  // of one reference
constexpr std::size_t kMostReferences = 10'000;

bool isDigits(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

std::vector<std::string_view> splitAt(std::string_view text, char between) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(between);
        parts.push_back(trimmed(text.substr(0, end)));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

std::string componentsOf(std::string_view name) {
    std::string joined;
    for (const std::string_view part : splitAt(name, '^')) {
        if (part.empty()) continue;
        if (!joined.empty()) joined += ", ";
        joined += part;
    }
    return joined;
}

}  // namespace

std::string inLines(std::string_view text) {
    std::string lines;
    while (!text.empty()) {
        const std::size_t end = text.find_first_of("\r\n");
        std::string line(text.substr(0, end));
        std::ranges::replace(line, '\t', ' ');
        lines += printable(line);
        if (end == std::string_view::npos) break;
        lines += '\n';
        text.remove_prefix(text.substr(end).starts_with("\r\n") ? end + 2 : end + 1);
    }
    return std::string(trimmed(lines));
}

Text wordsOf(const Dataset& item, Tag tag) {
    const auto text = item.text(tag);
    return text ? Text::verbatim(inLines(*text)) : Text();
}

CodedName codeIn(const Dataset& item, Tag sequence) {
    const std::vector<Dataset> codes = item.items(sequence);
    if (codes.empty()) return {};
    const Dataset& code = codes.front();
    CodedName name;
    for (const Tag value : {tag::kCodeValue, document_tag::kLongCodeValue, document_tag::kUrnCodeValue}) {
        if (name.value.empty()) name.value = inLines(code.text(value).value_or(""));
    }
    name.scheme = inLines(code.text(document_tag::kCodingScheme).value_or(""));
    name.meaning = inLines(code.text(document_tag::kCodeMeaning).value_or(""));
    return name;
}

Text wordsOf(const CodedName& code) {
    if (!code.meaning.empty()) return Text::verbatim(code.meaning);
    if (code.value.empty()) return {};
    if (code.scheme.empty()) return Text::verbatim(code.value);
    return Text::verbatim(fmt::format("{} ({})", code.value, code.scheme));
}

std::string unitOf(const CodedName& unit) {
    constexpr std::array kUnits = std::to_array<std::pair<std::string_view, std::string_view>>({
        {"1", ""},
        {"[hnsf'U]", "HU"},
        {"mm2", "mm²"},
        {"cm2", "cm²"},
        {"mm3", "mm³"},
        {"cm3", "cm³"},
        {"deg", "°"},
        {"um", "µm"},
        {"g/ml{SUVbw}", "g/ml (SUVbw)"},
    });
    if (unit.scheme != "UCUM") return unit.meaning.empty() ? unit.value : unit.meaning;
    for (const auto& [code, written] : kUnits) {
        if (unit.value == code) return std::string(written);
    }
    // Other codes with brackets or braces are no words for people.
    const bool isPlain = !unit.value.empty() && unit.value.find_first_of("[]{}*") == std::string::npos;
    return isPlain || unit.meaning.empty() ? unit.value : unit.meaning;
}

std::string personOf(std::string_view name) {
    std::string first;
    std::string others;
    for (const std::string_view representation : splitAt(name, '=')) {
        const std::string words = componentsOf(representation);
        if (words.empty() || words == first) continue;
        if (first.empty())
            first = words;
        else
            others += (others.empty() ? "" : "; ") + words;
    }
    return inLines(others.empty() ? first : fmt::format("{} ({})", first, others));
}

std::string dateOf(std::string_view date) {
    constexpr std::size_t kDay = 8;
    date = trimmed(date);
    if (date.size() != kDay || !isDigits(date)) return inLines(date);
    return fmt::format("{}-{}-{}", date.substr(0, 4), date.substr(4, 2), date.substr(6, 2));
}

std::string timeOf(std::string_view time) {
    time = trimmed(time);
    const std::string_view whole = time.substr(0, time.find('.'));
    const bool isKnown = isDigits(whole) && (whole.size() == 4 || whole.size() == 6);
    if (!isKnown) return inLines(time);
    std::string text = fmt::format("{}:{}", whole.substr(0, 2), whole.substr(2, 2));
    if (whole.size() == 6) text += fmt::format(":{}", whole.substr(4, 2));
    return text;
}

std::string dateTimeOf(std::string_view dateTime) {
    constexpr std::size_t kDay = 8;
    dateTime = trimmed(dateTime);
    const std::size_t zone = dateTime.find_first_of("+-");
    const std::string_view moment = dateTime.substr(0, zone);
    if (moment.size() < kDay || !isDigits(moment.substr(0, kDay))) return inLines(dateTime);
    std::string text = dateOf(moment.substr(0, kDay));
    if (moment.size() > kDay) text += ' ' + timeOf(moment.substr(kDay));
    if (zone != std::string_view::npos) text += ' ' + inLines(dateTime.substr(zone));
    return text;
}

std::string numberText(double number) {
    return fmt::format("{:.10g}", number);
}

std::vector<DocumentReference> referencesIn(const Dataset& item, Tag sequence, std::size_t& unusable) {
    std::vector<DocumentReference> references;
    for (const Dataset& each : item.items(sequence)) {
        DocumentReference reference;
        reference.sopClassUid = each.shortText(document_tag::kReferencedSopClassUid);
        reference.sopInstanceUid = each.shortText(document_tag::kReferencedSopInstanceUid);
        if (reference.sopInstanceUid.empty() || references.size() == kMostReferences) {
            ++unusable;
            continue;
        }
        for (const double frame : each.allNumbers(document_tag::kReferencedFrames)) {
            constexpr double kLastFrame = 1e6;
            if (frame >= 1.0 && frame <= kLastFrame && reference.frames.size() < kMostFrames)
                reference.frames.push_back(int(frame));
        }
        references.push_back(std::move(reference));
    }
    return references;
}

Text nameOf(const DocumentReference& reference) {
    const std::string& uid = reference.sopClassUid;
    const std::string_view modality = modalityOfClass(uid);
    Text kind = uid.empty()                          ? Text("An object")
                : !modality.empty()                  ? Text("{} image", std::string(modality))
                : isImage(uid) && !isProjection(uid) ? Text("Image")
                                                     : describeSopClass(uid);
    if (reference.frames.empty()) return kind;
    constexpr std::size_t kMostSaid = 8;
    std::string frames;
    for (std::size_t i = 0; i < std::min(reference.frames.size(), kMostSaid); ++i)
        frames += (i == 0 ? "" : ", ") + std::to_string(reference.frames[i]);
    if (reference.frames.size() > kMostSaid) frames += ", …";
    return reference.frames.size() == 1 ? Text("{}, frame {}", std::move(kind), frames)
                                        : Text("{}, frames {}", std::move(kind), frames);
}

}  // namespace macula::dicom
