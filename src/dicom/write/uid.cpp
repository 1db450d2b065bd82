#include "dicom/write/uid.h"

#include <fmt/format.h>

#include <cstdint>
#include <random>

#include "base/sha256.h"

namespace macula::dicom {

std::string uidFrom(std::string_view text) {
    return uidFromSha256(sha256Hex(text));
}

std::string uidFromSha256(std::string_view hex) {
    std::string decimal = "0";
    for (const char c : hex.substr(0, 32)) {
        int carry = c <= '9' ? c - '0' : c - 'a' + 10;
        for (auto digit = decimal.rbegin(); digit != decimal.rend(); ++digit) {
            const int sum = (*digit - '0') * 16 + carry;
            *digit = static_cast<char>('0' + sum % 10);
            carry = sum / 10;
        }
        for (; carry > 0; carry /= 10) decimal.insert(decimal.begin(), static_cast<char>('0' + carry % 10));
    }
    return "2.25." + decimal;
}

std::string newUid() {
    std::random_device chance;  // 32 bits a call, from the system
    std::string text;
    for (int i = 0; i < 8; ++i) text += fmt::format("{:08x}", chance());
    return uidFrom(text);
}

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
