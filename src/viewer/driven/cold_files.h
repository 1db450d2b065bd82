// Drops files from the system's cache, so that a study opens as it does the first time.
#pragma once

#include <cstdint>
#include <filesystem>

namespace macula::viewer {

struct ColdFiles {
    std::size_t files = 0;
    std::uint64_t bytes = 0;
    // Bytes still cached after posix_fadvise(DONTNEED): pages that another program has mapped or not written
    // yet. The disc's own cache is unknown. A file whose state is unknown counts in full.
    std::uint64_t bytesStillCached = 0;
};

// Drops a file, or all files below a folder. Does not follow links, needs only read rights, and leaves out
// unreadable files.
ColdFiles dropFromCache(const std::filesystem::path& path);

}  // namespace macula::viewer
