#include "viewer/driven/cold_files.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>
#include <vector>

namespace macula::viewer {

namespace {

namespace fs = std::filesystem;

// Of a file that is open.
std::uint64_t bytesCached(int file, std::uint64_t bytes) {
    if (bytes == 0) return 0;
    void* mapped = mmap(nullptr, bytes, PROT_READ, MAP_SHARED, file, 0);
    if (mapped == MAP_FAILED) return bytes;  // nobody knows: the worse is told
    const auto page = std::uint64_t(sysconf(_SC_PAGESIZE));
    std::vector<unsigned char> pages((bytes + page - 1) / page);
    std::uint64_t cached = bytes;
    if (mincore(mapped, bytes, pages.data()) == 0) {
        const auto there = std::count_if(pages.begin(), pages.end(), [](auto p) { return (p & 1) != 0; });
        cached = std::min(bytes, std::uint64_t(there) * page);
    }
    munmap(mapped, bytes);
    return cached;
}

void drop(const fs::path& path, ColdFiles& cold) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (file < 0) return;
    struct stat status {};
    if (fstat(file, &status) == 0 && S_ISREG(status.st_mode)) {
        const auto bytes = std::uint64_t(std::max<off_t>(status.st_size, 0));
        fdatasync(file);  // pages that are not written yet stay
        posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
        ++cold.files;
        cold.bytes += bytes;
        cold.bytesStillCached += bytesCached(file, bytes);
    }
    close(file);
}

}  // namespace

ColdFiles dropFromCache(const fs::path& path) {
    ColdFiles cold;
    std::error_code error;
    if (!fs::is_directory(path, error)) {
        drop(path, cold);
        return cold;
    }
    fs::recursive_directory_iterator at(path, fs::directory_options::skip_permission_denied, error);
    for (const fs::recursive_directory_iterator end; !error && at != end; at.increment(error)) {
        if (std::error_code unknown; at->is_regular_file(unknown)) drop(at->path(), cold);
    }
    return cold;
}

}  // namespace macula::viewer
