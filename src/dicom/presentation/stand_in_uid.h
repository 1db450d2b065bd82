// UIDs that stand in presentations without a patient for those of series, frame of reference and images.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/installation_key.h"

namespace macula::dicom {

// Keyed: who has the images and not the key of the installation cannot tell that it is meant.
std::string standInUid(const InstallationKey& key, std::string_view uid);

// Those that may have been written for a UID, by this installation or by Macula before there were keys.
class StandInUids {
  public:
    StandInUids() : key_(InstallationKey::find()) {}
    std::vector<std::string> of(std::string_view uid) const;
    // Of a UID of which only sha256Hex is known.
    std::vector<std::string> ofDigest(std::string_view digest) const;

  private:
    std::optional<InstallationKey> key_;
};

}  // namespace macula::dicom
