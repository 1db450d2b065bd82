#include "study/link/link_text.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "base/parsing.h"
#include "base/printable.h"
#include "base/utf8.h"

namespace macula::study {

namespace {

constexpr std::size_t kMostParameters = 32;
constexpr std::string_view kScheme = "macula:";
constexpr std::string_view kInvoke = "iheinvokeimagedisplay";

std::string lowerCaseOf(std::string_view text) {
    return lowerCase(std::string(text));
}

bool isOfTheWeb(std::string_view text) {
    const std::string begin = lowerCaseOf(text.substr(0, std::string_view("https://").size()));
    return begin.starts_with("http://") || begin.starts_with("https://");
}

// What stands before the query, and the query; nothing without one.
struct Halves {
    std::string_view place;
    std::optional<std::string_view> query;
};

Halves halvesOf(std::string_view text) {
    const std::size_t mark = text.find('?');
    if (mark == std::string_view::npos) return {text, {}};
    return {text.substr(0, mark), text.substr(mark + 1)};
}

// Browsers and desktops change the case of what they take for a host, and add a slash behind it.
std::string verbOf(std::string_view place) {
    if (place.ends_with('/')) place.remove_suffix(1);
    return lowerCaseOf(place);
}

bool isInvokeAddress(std::string_view text) {
    if (!isOfTheWeb(text)) return false;
    const std::string_view place = halvesOf(text).place;
    const std::size_t slash = place.rfind('/');
    return slash != std::string_view::npos && lowerCaseOf(place.substr(slash + 1)) == kInvoke;
}

std::optional<int> digitOf(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return {};
}

// RFC 3986 2.1. A plus sign stands for itself: only forms write blanks so. Nothing for an escape that is
// none.
std::optional<std::string> decoded(std::string_view text) {
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            bytes += text[i];
            continue;
        }
        if (text.size() - i < 3) return {};
        const auto high = digitOf(text[i + 1]);
        const auto low = digitOf(text[i + 2]);
        if (!high || !low) return {};
        bytes += static_cast<char>(16 * *high + *low);
        i += 2;
    }
    return bytes;
}

Result<std::string> readable(std::string_view text) {
    const auto bytes = decoded(text);
    if (!bytes) return badLink(Text("The link has a percent sign without two digits behind it."));
    if (!isValidUtf8(*bytes)) return badLink(Text("The link holds letters that are not UTF-8."));
    if (printable(*bytes) != *bytes) return badLink(Text("The link holds control characters."));
    return *bytes;
}

Result<std::vector<LinkParameter>> parametersOf(std::string_view query) {
    std::vector<LinkParameter> parameters;
    std::set<std::string> keys;
    while (!query.empty()) {
        const std::size_t end = std::min(query.find('&'), query.size());
        const std::string_view part = query.substr(0, end);
        query.remove_prefix(std::min(end + 1, query.size()));
        if (part.empty()) continue;
        const std::size_t sign = part.find('=');
        if (sign == std::string_view::npos || sign == 0)
            return badLink(Text("The link has a part that is not written as key=value."));
        MACULA_TRY(std::string key, readable(part.substr(0, sign)));
        MACULA_TRY(std::string value, readable(part.substr(sign + 1)));
        if (!keys.insert(key).second) return badLink(Text("The link gives one of its keys twice."));
        if (keys.size() > kMostParameters) return badLink(Text("The link has too many parts."));
        if (!value.empty()) parameters.push_back({std::move(key), std::move(value)});
    }
    return parameters;
}

Result<LinkText::Kind> kindOf(std::string_view link) {
    if (isInvokeAddress(link)) {
        if (halvesOf(link).place.find('@') != std::string_view::npos)
            return badLink(Text("The link holds a user name or a password."));
        return LinkText::Kind::invokeImageDisplay;
    }
    if (!lowerCaseOf(link.substr(0, kScheme.size())).starts_with(kScheme))
        return badLink(Text("This is no link of Macula."));
    link.remove_prefix(kScheme.size());
    if (!link.starts_with("//")) return badLink(Text("The link has no // behind its beginning."));
    const std::string verb = verbOf(halvesOf(link.substr(2)).place);
    if (verb == "open") return LinkText::Kind::open;
    if (verb == kInvoke) return LinkText::Kind::invokeImageDisplay;
    return badLink(Text("The link asks for something that Macula does not do."));
}

}  // namespace

Error badLink(Text message) {
    return {ErrorCode::usage,
            std::move(message),
            {},
            Text("Nothing was opened. Links are written as macula://open?study=UID, with accession=NUMBER or "
                 "patient=ID instead of study, and may end in &archive=NAME; or as "
                 "macula://IHEInvokeImageDisplay?requestType=STUDY&studyUID=UID.")};
}

bool isLink(std::string_view text) {
    return lowerCaseOf(text.substr(0, kScheme.size())) == kScheme || isInvokeAddress(text);
}

Result<LinkText> linkTextOf(std::string_view link) {
    if (link.size() > kMostBytesOfLink) return badLink(Text("The link is too long."));
    const bool hasBlanks = std::any_of(
        link.begin(), link.end(), [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == '\x7f'; });
    if (hasBlanks) return badLink(Text("The link holds a blank or a control character."));
    MACULA_TRY(const LinkText::Kind kind, kindOf(link));
    if (link.find('#') != std::string_view::npos)
        return badLink(Text("The link has a # in it; within a value it is written as %23."));
    const auto query = halvesOf(link).query;
    if (!query) return badLink(Text("The link does not say which study it means."));
    MACULA_TRY(std::vector<LinkParameter> parameters, parametersOf(*query));
    return LinkText{kind, std::move(parameters)};
}

}  // namespace macula::study
