#include "net/dimse/identifier.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcspchrs.h>

#include <algorithm>
#include <charconv>

#include "base/utf8.h"
#include "net/archive/file_meta.h"
#include "net/dimse/contexts.h"
#include "net/dimse/elements.h"
#include "toolkit/character_set.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::net {

namespace {

constexpr std::size_t kLongestValue = 1024;
constexpr const char* kUtf8 = "ISO_IR 192";

struct KeyInfo {
    Key key;
    const char* representation;
    bool isText;  // in the character set of the identifier
};
constexpr std::array kKeyInfos = std::to_array<KeyInfo>({
    {Key::specificCharacterSet, "CS", false},
    {Key::sopClassUid, "UI", false},
    {Key::sopInstanceUid, "UI", false},
    {Key::studyDate, "DA", false},
    {Key::studyTime, "TM", false},
    {Key::accessionNumber, "SH", true},
    {Key::level, "CS", false},
    {Key::modality, "CS", false},
    {Key::modalitiesInStudy, "CS", false},
    {Key::referringPhysician, "PN", true},
    {Key::studyDescription, "LO", true},
    {Key::seriesDescription, "LO", true},
    {Key::patientName, "PN", true},
    {Key::patientId, "LO", true},
    {Key::patientBirthDate, "DA", false},
    {Key::patientSex, "CS", false},
    {Key::bodyPart, "CS", false},
    {Key::studyInstanceUid, "UI", false},
    {Key::seriesInstanceUid, "UI", false},
    {Key::studyId, "SH", true},
    {Key::seriesNumber, "IS", false},
    {Key::instanceNumber, "IS", false},
    {Key::seriesOfStudy, "IS", false},
    {Key::instancesOfStudy, "IS", false},
    {Key::instancesOfSeries, "IS", false},
});

const KeyInfo* infoOf(std::uint32_t tag) {
    const auto found = std::ranges::find(kKeyInfos, static_cast<Key>(tag), &KeyInfo::key);
    return found == kKeyInfos.end() ? nullptr : &*found;
}

bool isAscii(std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

// From one character set to another; empty if a character cannot be written, or the set is unknown.
std::optional<std::string> converted(const std::string& text, const std::string& from, const std::string& to,
                                     bool isName) {
    const QuietToolkit quiet;
    DcmSpecificCharacterSet sets;
    if (sets.selectCharacterSet(from.c_str(), to.c_str()).bad()) return {};
    OFString result;
    const OFCondition done = sets.convertString(text.data(), text.size(), result, isName ? "\\^=" : "\\");
    if (done.bad()) return {};
    return std::string(result.c_str(), result.length());
}

void appendElement(std::vector<unsigned char>& bytes, const KeyInfo& info, std::string value,
                   bool isExplicit) {
    const std::string_view representation = info.representation;
    if (value.size() % 2 != 0) value += representation == "UI" ? '\0' : ' ';
    const auto little = [&](std::size_t number, int count) {
        for (int i = 0; i < count; ++i) bytes.push_back(static_cast<unsigned char>(number >> (8 * i)));
    };
    little(static_cast<std::uint32_t>(info.key) >> 16, 2);
    little(static_cast<std::uint32_t>(info.key) & 0xffffu, 2);
    if (isExplicit) bytes.insert(bytes.end(), representation.begin(), representation.end());
    little(value.size(), isExplicit ? 2 : 4);
    bytes.insert(bytes.end(), value.begin(), value.end());
}

std::string withoutControls(std::string text) {
    std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
    return std::string(startOf(text, kLongestValue));
}

}  // namespace

Result<std::vector<unsigned char>> identifierBytes(const Keys& keys, std::string_view transferSyntax,
                                                   const std::string& characterSet) {
    Keys all = keys;
    if (!characterSet.empty()) all[Key::specificCharacterSet] = characterSet;
    std::vector<unsigned char> bytes;
    for (const auto& [key, value] : all) {
        const KeyInfo* info = infoOf(static_cast<std::uint32_t>(key));
        MACULA_CHECK(info != nullptr);
        std::optional<std::string> written = value;
        if (!isAscii(value) && characterSet != kUtf8)
            written = converted(value, kUtf8, characterSet, std::string_view(info->representation) == "PN");
        if (!written || !isValidUtf8(value) || written->size() > 0xfffe)
            return Error{ErrorCode::usage,
                         Text("What is searched for cannot be written in this archive's character set."),
                         {},
                         Text("Search with fewer special characters, or change the character set in the "
                              "archive's settings.")};
        appendElement(bytes, *info, *written, transferSyntax == kExplicitLittleEndian);
    }
    return bytes;
}

std::optional<Keys> identifierOf(std::span<const unsigned char> bytes, std::string_view transferSyntax) {
    Encoding encoding{};
    if (!encodingOf(transferSyntax, encoding)) return {};
    Keys raw;
    const bool isWhole = forEachElement(bytes, encoding, [&](const Element& element) {
        if (infoOf(element.tag) != nullptr) raw[static_cast<Key>(element.tag)] = textOf(element);
        return true;
    });
    if (!isWhole) return {};
    const auto named = raw.find(Key::specificCharacterSet);
    const std::string characterSet = named == raw.end() ? std::string() : named->second;
    Keys keys;
    for (const auto& [key, value] : raw) {
        const KeyInfo* info = infoOf(static_cast<std::uint32_t>(key));
        const std::string start = value.substr(0, 4 * kLongestValue);
        const bool isName = std::string_view(info->representation) == "PN";
        const DecodedText text =
            decodeText(start, info->isText ? std::string_view(characterSet) : std::string_view(),
                       isName ? Delimiters::ofPersonNames : Delimiters::betweenValues);
        keys[key] = withoutControls(text.utf8);
    }
    return keys;
}

std::vector<std::string> allValues(const Keys& keys, Key key) {
    std::vector<std::string> values;
    const auto found = keys.find(key);
    if (found == keys.end()) return values;
    std::string_view rest = found->second;
    while (true) {
        const std::size_t end = rest.find('\\');
        std::string_view value = rest.substr(0, end);
        while (value.ends_with(' ')) value.remove_suffix(1);
        while (value.starts_with(' ')) value.remove_prefix(1);
        values.emplace_back(value);
        if (end == std::string_view::npos) return values;
        rest.remove_prefix(end + 1);
    }
}

std::string firstValue(const Keys& keys, Key key) {
    const std::vector<std::string> values = allValues(keys, key);
    return values.empty() ? std::string() : values.front();
}

std::string uidValue(const Keys& keys, Key key) {
    const std::vector<std::string> values = allValues(keys, key);
    return values.size() == 1 && isUid(values.front()) ? values.front() : std::string();
}

std::optional<int> numberValue(const Keys& keys, Key key) {
    const std::string text = firstValue(keys, key);
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    int number = 0;
    const auto [end, problem] = std::from_chars(begin, text.data() + text.size(), number);
    if (text.empty() || problem != std::errc{} || end != text.data() + text.size()) return {};
    return number;
}

}  // namespace macula::net
