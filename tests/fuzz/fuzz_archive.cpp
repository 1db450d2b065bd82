// Any bytes as a ZIP, tar or ISO 9660 file: what comes out of it is regular files under safe names, inside.
#include <string>
#include <string_view>

#include "fuzz/file_of_bytes.h"
#include "unpack/archive_name.h"
#include "unpack/unpacked_archive.h"

namespace {

namespace fs = std::filesystem;

bool isSafe(const std::string& name) {
    constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_./";
    return !name.empty() && name.find_first_not_of(kPlain) == std::string::npos;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    setenv("XDG_DATA_HOME", macula::fuzz::folder().c_str(), 1);
    const fs::path file = macula::fuzz::fileOf(data, size, "study.zip");
    (void)macula::unpack::isArchive(file);
    macula::Progress progress;
    {
        const auto copy = macula::unpack::unpack(
            file, progress,
            {.mostEntries = 1000, .mostBytes = 8u << 20, .bytesInAnyCase = 4u << 20, .leastFreeBytes = 0});
        std::size_t files = 0;
        if (copy) {
            const fs::path folder = (*copy)->folder();
            for (const fs::directory_entry& each : fs::recursive_directory_iterator(folder)) {
                MACULA_CHECK(!each.is_symlink() && (each.is_directory() || each.is_regular_file()));
                MACULA_CHECK(isSafe(each.path().lexically_relative(folder).string()));
                files += each.is_regular_file() ? 1 : 0;
            }
            MACULA_CHECK(files == (*copy)->facts().files);
        }
    }
    MACULA_CHECK(fs::is_empty(macula::unpack::unpackedFolder()));
    return 0;
}
