// UIDs that replace those of series, frame of reference and images in deidentified presentations.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/installation_key.h"

namespace macula::dicom {

// Keyed: without the installation's key, not even somebody who has the images can tell that a stand-in means
// `uid`.
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
