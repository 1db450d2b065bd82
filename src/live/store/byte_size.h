// Sizes in bytes as people write and read them. 1 MB is 1 000 000 bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace macula::live {

// "1.4 MB", "140 MB", "2.0 GB".
std::string sizeForPeople(std::uint64_t bytes);

// Reads "123456789 B", "500 MB", "1.5GB" or "2 GiB", in any case. Nothing for other text, for a number
// without a unit, which would be ambiguous, and for sizes larger than any disk.
std::optional<std::uint64_t> bytesOfText(std::string_view text);

}  // namespace macula::live
