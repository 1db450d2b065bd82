// The address of a service in the web, taken apart by the same rules that the connection goes by.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace macula::net {

struct WebAddress {
    bool isSecure = false;  // https
    std::string host;       // in lower case; of IPv6 in brackets
    std::string port;       // always there
    std::string url;        // without a slash at its end
};

// Fails with usage where the text is no address of http or https, or holds a user name, a password, a query
// or a fragment.
Result<WebAddress> webAddressOf(const std::string& url);

// Whether the address is on this machine whatever a name server says.
bool isLoopback(const WebAddress& address);

// What a password may be sent to: over TLS, or to this machine.
bool mayHearSecrets(const WebAddress& address);

// Whether an answer of `from` may send the request on to `to`: on the same host and port, or there from http
// to https. Credentials, and requests that name patients, go nowhere else.
bool mayRedirect(const std::string& from, const std::string& to);

// Everything but letters, digits, and -._~ as %XX (RFC 3986 2.1).
std::string percentEncoded(std::string_view text);

// Of a value in a query: leaves what may stand there too, such as wildcards, since some archives do not
// decode.
std::string queryEncoded(std::string_view text);
bool isPlainInQuery(char c);

}  // namespace macula::net
