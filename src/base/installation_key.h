// The secret of this installation. Identifiers can be guessed, so a digest of one that leaves the machine is
// keyed with it: whoever lacks the key can neither read it nor try identifiers out.
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
    // That of the user, in the file installation.key (mode 0600) of that folder; made by chance where there
    // is none. Fails with outputNotWritable where it cannot be kept, and with inputNotUsable where what is
    // there is no key.
    static Result<InstallationKey> ofUser(const std::filesystem::path& folder = userDataFolder());
    // For who looks for what was written with it before: nothing where there is none, and none is made.
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
