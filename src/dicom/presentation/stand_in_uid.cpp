#include "dicom/presentation/stand_in_uid.h"

#include "base/sha256.h"
#include "dicom/write/uid.h"

namespace macula::dicom {

std::string standInUid(const InstallationKey& key, std::string_view uid) {
    return uidFromSha256(key.digestOf(sha256Hex(uid)));
}

std::vector<std::string> StandInUids::of(std::string_view uid) const {
    return ofDigest(sha256Hex(uid));
}

std::vector<std::string> StandInUids::ofDigest(std::string_view digest) const {
    std::vector<std::string> uids;
    if (key_) uids.push_back(uidFromSha256(key_->digestOf(digest)));
    uids.push_back(uidFromSha256(digest));
    return uids;
}

}  // namespace macula::dicom
