// Makes UIDs that need no registration.
#pragma once

#include <string>
#include <string_view>

namespace macula::dicom {

// "2.25." and the decimal form of 128 bits (PS3.5 B.2). uidFrom takes the first 128 bits of the text's
// SHA-256, without the version bits of a UUID; the same text gives the same UID. newUid is random, and never
// the same twice.
std::string uidFrom(std::string_view text);
std::string newUid();
// uidFrom of a text of which only sha256Hex is known; of at least 32 hexadecimal digits, lower case.
std::string uidFromSha256(std::string_view hex);

}  // namespace macula::dicom
