#include "base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <utility>

namespace macula {

FileLock::FileLock(const std::filesystem::path& file)
    : descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600)) {}

FileLock::FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

FileLock::~FileLock() {
    if (descriptor_ >= 0) close(descriptor_);
}

bool FileLock::isOurs() const {
    return descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
}

// A shared lock keeps out only those who take it, and for no longer than this call.
bool FileLock::isFree() const {
    if (descriptor_ < 0 || flock(descriptor_, LOCK_SH | LOCK_NB) != 0) return false;
    flock(descriptor_, LOCK_UN);
    return true;
}

}  // namespace macula
