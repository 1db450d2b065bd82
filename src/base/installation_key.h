// The secret key of this installation. Identifiers can be guessed, so their digests are keyed before they
// leave the machine: without the key nobody can reverse a digest by trying identifiers out.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "base/user_folder.h"

namespace macula {

class InstallationKey {
  public:
    // Reads the user's key from the file installation.key (mode 0600) in `folder`, or makes a random one when
    // there is none. Fails with outputNotWritable when it cannot store the key, and with inputNotUsable when
    // the file holds no key.
    static Result<InstallationKey> ofUser(const std::filesystem::path& folder = userDataFolder());
    // The key if there is one, to find objects that were written with it earlier. Never makes one.
    static std::optional<InstallationKey> find(const std::filesystem::path& folder = userDataFolder());

    // HMAC-SHA256 of the text, 64 lower-case hexadecimal digits.
    std::string digestOf(std::string_view text) const;

  private:
    using Bytes = std::array<std::byte, 32>;
    explicit InstallationKey(const Bytes& bytes) : bytes_(bytes) {}
    static Result<std::optional<InstallationKey>> read(const std::filesystem::path& file);

    Bytes bytes_;
};

}  // namespace macula
