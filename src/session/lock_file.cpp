#include "session/lock_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <thread>

#include "base/parsing.h"
#include "session/trouble.h"

namespace macula::session {

namespace {

struct flock lockOf(off_t byte, int type) {
    struct flock lock {};
    lock.l_type = static_cast<short>(type);
    lock.l_whence = SEEK_SET;
    lock.l_start = byte;
    lock.l_len = 1;
    return lock;
}

}  // namespace

off_t LockFile::byteOf(std::string_view keyDigest) {
    constexpr off_t kFirst = 16;
    off_t number = 0;  // below 2^60
    for (const char digit : keyDigest.substr(0, 15))
        number = number * 16 + (digit >= 'a' ? digit - 'a' + 10 : digit - '0');
    return kFirst + number;
}

Result<std::shared_ptr<LockFile>> LockFile::open(const std::filesystem::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (descriptor < 0) return errorOf(troubleOfErrno(errno), file);
    return std::shared_ptr<LockFile>(new LockFile(file, descriptor));
}

LockFile::~LockFile() {
    close(descriptor_);
}

int LockFile::set(off_t byte, int type) {
    struct flock lock = lockOf(byte, type);
    while (fcntl(descriptor_, F_OFD_SETLK, &lock) != 0)
        if (errno != EINTR) return errno;
    return 0;
}

Result<void> LockFile::acquire(off_t byte, Hold hold, std::chrono::milliseconds patience) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point end = Clock::now() + patience;
    // Polls, because F_OFD_SETLKW has no timeout.
    for (auto pause = std::chrono::milliseconds(1);;
         pause = std::min(2 * pause, std::chrono::milliseconds(20))) {
        const int reason = set(byte, hold == Hold::shared ? F_RDLCK : F_WRLCK);
        if (reason == 0) return {};
        if (reason != EAGAIN && reason != EACCES)
            return errorOf(reason == EINVAL ? Trouble::noLocks : troubleOfErrno(reason), file_);
        if (Clock::now() >= end) return errorOf(Trouble::lockedByAnother, file_);
        std::this_thread::sleep_for(pause);
    }
}

void LockFile::release(off_t byte) {
    set(byte, F_UNLCK);
}

Result<void> LockFile::addMark(off_t byte) {
    const std::lock_guard guard(mutex_);
    if (marks_[byte] == 0) {
        if (auto locked = acquire(byte, Hold::shared, std::chrono::milliseconds(100)); !locked) {
            marks_.erase(byte);
            return locked;
        }
    }
    ++marks_[byte];
    return {};
}

void LockFile::removeMark(off_t byte) {
    const std::lock_guard guard(mutex_);
    if (--marks_[byte] > 0) return;
    marks_.erase(byte);
    release(byte);
}

bool LockFile::isMarked(off_t byte) {
    const std::lock_guard guard(mutex_);
    if (marks_.contains(byte)) return true;
    struct flock lock = lockOf(byte, F_WRLCK);
    return fcntl(descriptor_, F_OFD_GETLK, &lock) != 0 || lock.l_type != F_UNLCK;
}

Result<HeldLock> HeldLock::take(std::shared_ptr<LockFile> file, off_t byte, Hold hold,
                                std::chrono::milliseconds patience) {
    MACULA_TRY_VOID(file->acquire(byte, hold, patience));
    return HeldLock(std::move(file), byte);
}

}  // namespace macula::session
