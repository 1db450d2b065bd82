// Files that no memory of the system holds: what a study is opened with for the first time.
#pragma once

#include <cstdint>
#include <filesystem>

namespace macula::viewer {

struct ColdFiles {
    std::size_t files = 0;
    std::uint64_t bytes = 0;
    // Of them, still in the cache of the system after it was asked to let go (posix_fadvise, DONTNEED): pages
    // that another program has mapped, or has not written yet. What is beneath, a disc's own cache, is not
    // known.
    std::uint64_t bytesStillCached = 0;
};

// A file, or all below a folder; links are not followed. Needs no rights but to read. What cannot be read is
// left out.
ColdFiles dropFromCache(const std::filesystem::path& path);

}  // namespace macula::viewer
