#include "net/web/web_address.h"

#include <arpa/inet.h>
#include <curl/curl.h>
#include <netinet/in.h>

#include <memory>

#include "base/parsing.h"

namespace macula::net {

namespace {

constexpr unsigned kFirstOfLoopback = 127;  // 127.0.0.0/8

using UrlHandle = std::unique_ptr<CURLU, decltype(&curl_url_cleanup)>;

UrlHandle parsedUrl(const std::string& url) {
    UrlHandle handle(curl_url(), curl_url_cleanup);
    if (handle && curl_url_set(handle.get(), CURLUPART_URL, url.c_str(), 0) != CURLUE_OK) handle.reset();
    return handle;
}

std::string partOfUrl(CURLU* handle, CURLUPart part, unsigned flags = 0) {
    char* text = nullptr;
    if (curl_url_get(handle, part, &text, flags) != CURLUE_OK || text == nullptr) return {};
    std::string copy(text);
    curl_free(text);
    return copy;
}

Error badAddress(Text message) {
    return {ErrorCode::usage,
            std::move(message),
            {},
            Text("Enter the address of the DICOMweb service, such as https://pacs.example.org/dicom-web.")};
}

// RFC 3986 2.3.
bool isUnreserved(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '.' || c == '_' || c == '~';
}

std::string encodedBut(bool (*isPlain)(char), std::string_view text) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string encoded;
    for (const char c : text) {
        if (isPlain(c)) {
            encoded += c;
            continue;
        }
        const auto byte = static_cast<unsigned char>(c);
        encoded += '%';
        encoded += kDigits[byte >> 4];
        encoded += kDigits[byte & 15];
    }
    return encoded;
}

}  // namespace

Result<WebAddress> webAddressOf(const std::string& url) {
    for (const char c : url) {
        if (static_cast<unsigned char>(c) <= ' ' || c == '\x7f')
            return badAddress(Text("The address of the archive holds a blank or a control character."));
    }
    const UrlHandle handle = parsedUrl(url);
    if (!handle) return badAddress(Text("The address of the archive is not one of the web."));
    CURLU* const parts = handle.get();
    const std::string scheme = lowerCase(partOfUrl(parts, CURLUPART_SCHEME));
    if (scheme != "http" && scheme != "https")
        return badAddress(Text("The address of the archive begins with neither https:// nor http://."));
    if (!partOfUrl(parts, CURLUPART_USER).empty() || !partOfUrl(parts, CURLUPART_PASSWORD).empty())
        return badAddress(
            Text("The address of the archive holds a user name, which belongs into its own field."));
    if (url.find_first_of("?#") != std::string::npos)
        return badAddress(Text("The address of the archive has a question mark or a # in it."));
    WebAddress address;
    address.isSecure = scheme == "https";
    address.host = lowerCase(partOfUrl(parts, CURLUPART_HOST));
    address.port = partOfUrl(parts, CURLUPART_PORT, CURLU_DEFAULT_PORT);
    address.url = partOfUrl(parts, CURLUPART_URL);
    while (address.url.ends_with('/')) address.url.pop_back();
    if (address.host.empty()) return badAddress(Text("The address of the archive names no host."));
    return address;
}

bool isLoopback(const WebAddress& address) {
    if (address.host == "localhost") return true;
    in_addr four{};
    if (inet_pton(AF_INET, address.host.c_str(), &four) == 1)
        return ntohl(four.s_addr) >> 24 == kFirstOfLoopback;
    if (address.host.size() < 2 || address.host.front() != '[') return false;
    in6_addr six{};
    const std::string inside = address.host.substr(1, address.host.size() - 2);
    return inet_pton(AF_INET6, inside.c_str(), &six) == 1 && IN6_IS_ADDR_LOOPBACK(&six);
}

bool mayHearSecrets(const WebAddress& address) {
    return address.isSecure || isLoopback(address);
}

bool mayRedirect(const std::string& from, const std::string& to) {
    const UrlHandle before = parsedUrl(from);
    const UrlHandle after = parsedUrl(to);
    if (!before || !after || !partOfUrl(after.get(), CURLUPART_USER).empty()) return false;
    const auto part = [](const UrlHandle& handle, CURLUPart which) {
        return lowerCase(partOfUrl(handle.get(), which, CURLU_DEFAULT_PORT));
    };
    if (part(before, CURLUPART_HOST) != part(after, CURLUPART_HOST)) return false;
    const std::string schemeBefore = part(before, CURLUPART_SCHEME);
    const std::string schemeAfter = part(after, CURLUPART_SCHEME);
    if (schemeBefore == schemeAfter) return part(before, CURLUPART_PORT) == part(after, CURLUPART_PORT);
    return schemeBefore == "http" && schemeAfter == "https";
}

std::string percentEncoded(std::string_view text) {
    return encodedBut(isUnreserved, text);
}

bool isPlainInQuery(char c) {
    // RFC 3986 3.4, without what separates values and what forms read as a blank.
    constexpr std::string_view kMore = "*?,:@/!$'()";
    return isUnreserved(c) || kMore.find(c) != std::string_view::npos;
}

std::string queryEncoded(std::string_view text) {
    return encodedBut(isPlainInQuery, text);
}

}  // namespace macula::net
