// Makes UIDs that need no registration.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/installation_key.h"

namespace macula::dicom {

// "2.25." and the decimal form of 128 bits (PS3.5 B.2). uidFrom takes the first 128 bits of the text's
// SHA-256, without the version bits of a UUID; the same text gives the same UID. newUid is random, and never
// the same twice.
std::string uidFrom(std::string_view text);
std::string newUid();
// uidFrom of a text of which only sha256Hex is known; of at least 32 hexadecimal digits, lower case.
std::string uidFromSha256(std::string_view hex);

// UIDs that replace those of series, frame of reference and images in deidentified presentations. Keyed:
// without the installation's key, not even somebody who has the images can tell that a stand-in means `uid`.
std::string standInUid(const InstallationKey& key, std::string_view uid);

// The stand-ins that this installation, or Macula before there were keys, may have written for a UID.
class StandInUids {
  public:
    StandInUids() : key_(InstallationKey::find()) {}
    std::vector<std::string> of(std::string_view uid) const;
    // The same for a UID of which only sha256Hex is known.
    std::vector<std::string> ofDigest(std::string_view digest) const;

  private:
    std::optional<InstallationKey> key_;
};

}  // namespace macula::dicom
