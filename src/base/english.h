// Sentences in English, for JSON reports and for the C interface.
#pragma once

#include <string>
#include <vector>

#include "base/text.h"

namespace macula {

inline std::vector<std::string> inEnglish(const std::vector<Text>& texts) {
    std::vector<std::string> english;
    english.reserve(texts.size());
    for (const Text& text : texts) english.push_back(text.english());
    return english;
}

}  // namespace macula
