#include "unpack/archive_name.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "base/parsing.h"

namespace macula::unpack {

using namespace std::literals;

namespace {

struct Magic {
    std::size_t at = 0;
    std::string_view bytes;
};
constexpr Magic kDicom{128, "DICM"sv};
constexpr std::array kMagics{Magic{0, "PK\x03\x04"sv},       Magic{0, "PK\x05\x06"sv},
                             Magic{257, "ustar"sv},          Magic{0, "\xfd\x37zXZ\0"sv},
                             Magic{0, "\x1f\x8b\x08"sv},     Magic{0, "BZh"sv},
                             Magic{0, "\x28\xb5\x2f\xfd"sv}, Magic{32769, "CD001"sv}};
// Also of kinds that are not opened: for them a person gets a sentence that says so.
constexpr std::array kEndings{".zip"sv, ".tar"sv, ".tgz"sv, ".txz"sv, ".tbz"sv, ".tbz2"sv, ".tzst"sv,
                              ".iso"sv, ".7z"sv,  ".rar"sv, ".gz"sv,  ".xz"sv,  ".bz2"sv,  ".zst"sv};

bool has(std::ifstream& file, const Magic& magic) {
    std::string found(magic.bytes.size(), '\0');
    file.clear();
    file.seekg(static_cast<std::streamoff>(magic.at));
    file.read(found.data(), static_cast<std::streamsize>(found.size()));
    return file.good() && found == magic.bytes;
}

}  // namespace

bool isArchive(const std::filesystem::path& path) {
    std::error_code failure;
    if (!std::filesystem::is_regular_file(path, failure)) return false;
    std::ifstream file(path, std::ios::binary);
    if (has(file, kDicom)) return false;
    if (std::ranges::any_of(kMagics, [&](const Magic& magic) { return has(file, magic); })) return true;
    const std::string ending = lowerCase(path.extension().string());
    return std::ranges::find(kEndings, ending) != kEndings.end();
}

}  // namespace macula::unpack
