// Sentences in English, as JSON reports have them.
#pragma once

#include <string>
#include <vector>

#include "base/text.h"

namespace macula::study {

inline std::vector<std::string> inEnglish(const std::vector<Text>& texts) {
    std::vector<std::string> english;
    english.reserve(texts.size());
    for (const Text& text : texts) english.push_back(text.english());
    return english;
}

}  // namespace macula::study
