#include "presets/preset_name.h"

#include <algorithm>
#include <array>

#include "base/parsing.h"

namespace macula::presets {

namespace {

struct Prefix {
    std::string_view text;
    std::string_view modality;
    Unit unit;
};
constexpr std::array<Prefix, 5> kPrefixes{{{"CT", "CT", Unit::hounsfield},
                                           {"MR", "MR", Unit::raw},
                                           {"DTI", "MR", Unit::raw},
                                           {"US", "US", Unit::raw},
                                           {"uCT", "CT", Unit::raw}}};

bool isLetterOrDigit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

}  // namespace

std::string keyFrom(std::string_view title) {
    constexpr std::size_t kLongest = 64;
    std::string key;
    for (const char c : lowerCase(std::string(title))) {
        if (isLetterOrDigit(c)) {
            key += c;
        } else if (!key.empty() && key.back() != '-') {
            key += '-';
        }
    }
    key.resize(std::min(key.size(), kLongest));
    while (key.ends_with('-')) key.pop_back();
    return key.empty() ? "preset" : key;
}

bool nameAfter(TransferFunction& function, std::string_view title) {
    function.name = keyFrom(title);
    function.title = title.empty() ? function.name : std::string(title);
    function.modalities = {"CT"};
    function.unit = Unit::hounsfield;
    const auto* const prefix = std::find_if(kPrefixes.begin(), kPrefixes.end(), [&](const Prefix& p) {
        return title.starts_with(p.text) && title.substr(p.text.size()).starts_with('-');
    });
    if (prefix == kPrefixes.end()) return false;
    function.modalities = {std::string(prefix->modality)};
    function.unit = prefix->unit;
    return true;
}

Text assumedHounsfield() {
    return Text("The file does not say what its values are; Hounsfield units of CT were assumed.");
}

}  // namespace macula::presets
