// Coded concepts of DICOM (PS3.3 8.8): a term of a vocabulary, and what it means for a person.
#pragma once

#include <string>

namespace macula {

// "121071", "DCM", "Finding": at most 16, 16 and 64 characters.
struct CodedName {
    std::string value;
    std::string scheme;
    std::string meaning;

    bool operator==(const CodedName&) const = default;
};

}  // namespace macula
