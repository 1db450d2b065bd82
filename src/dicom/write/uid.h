// Identifiers that nobody has to ask an authority for.
#pragma once

#include <string>
#include <string_view>

namespace macula::dicom {

// "2.25." and the decimal form of 128 bits (PS3.5 B.2). uidFrom: the first ones of a hash of the text, with
// the version bits of a UUID left as they fall; the same text gives the same UID. newUid: by chance, never
// the same twice.
std::string uidFrom(std::string_view text);
std::string newUid();
// uidFrom of a text of which only sha256Hex is known; of at least 32 hexadecimal digits, lower case.
std::string uidFromSha256(std::string_view hex);

}  // namespace macula::dicom
