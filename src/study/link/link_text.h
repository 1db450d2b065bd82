// A link taken apart into what it asks for and its parameters (RFC 3986), before anything of it is believed:
// any web page can make one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace macula::study {

inline constexpr std::size_t kMostBytesOfLink = 4096;

// Whether a person or a desktop means a link by this, and no path: it begins with macula:, or it is the web
// address of an Invoke Image Display (IHE RAD-106). It need not be a good one.
bool isLink(std::string_view text);

// Decoded: UTF-8 without control characters and without such as change the direction of text.
struct LinkParameter {
    std::string key;
    std::string value;  // not empty
};

struct LinkText {
    enum class Kind { open, invokeImageDisplay };

    Kind kind = Kind::open;
    std::vector<LinkParameter> parameters;  // each key once, in the order of the link
};

// The error to tell of a link, with how links look. `message` names no value of the link, since values may
// name a patient.
Error badLink(Text message);

// Fails with usage. Parameters with empty values are left out, as systems write them for what they do not
// know. The host of a web address means this program, as it does in RAD-106, and is not used.
Result<LinkText> linkTextOf(std::string_view link);

}  // namespace macula::study
