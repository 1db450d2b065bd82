// Locks between processes: bytes of one file, locked as open file descriptions are (F_OFD_SETLK of Linux). A
// lock ends with its process, however that ends. They work on network drives where the drive has locks, and
// say so where it has none.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string_view>

#include "base/result.h"

namespace macula::session {

enum class Hold { shared, exclusive };

// Thread-safe.
class LockFile {
  public:
    // Whoever has the store open shares this; who replaces the database has it alone.
    static constexpr off_t kPresence = 0;
    // Whoever copies or opens a blob shares this; who removes blobs has it alone.
    static constexpr off_t kBlobs = 1;
    // The byte of a model that is open, from the digest of its key. Two keys may have the same byte: then one
    // of them is kept longer than it must be.
    static off_t byteOf(std::string_view keyDigest);

    // Creates the file (0600) where it is missing.
    static Result<std::shared_ptr<LockFile>> open(const std::filesystem::path& file);
    ~LockFile();
    LockFile(const LockFile&) = delete;
    LockFile& operator=(const LockFile&) = delete;

    // Waits so long; fails with lockedByAnother after that, and with noLocks at once. A held lock is changed
    // to the other kind. Locks of one LockFile do not shut out each other.
    Result<void> acquire(off_t byte, Hold hold, std::chrono::milliseconds patience);
    void release(off_t byte);

    // Shared, and counted: released when each that was added is removed.
    Result<void> addMark(off_t byte);
    void removeMark(off_t byte);
    // By this store or by another one. When nobody can tell, it is marked.
    bool isMarked(off_t byte);

  private:
    LockFile(std::filesystem::path file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}
    int set(off_t byte, int type);  // 0, or errno

    std::filesystem::path file_;
    int descriptor_ = -1;
    std::mutex mutex_;
    std::map<off_t, int> marks_;
};

// Has a lock until it goes.
class HeldLock {
  public:
    static Result<HeldLock> take(std::shared_ptr<LockFile> file, off_t byte, Hold hold,
                                 std::chrono::milliseconds patience);
    HeldLock(HeldLock&& other) noexcept = default;
    HeldLock& operator=(HeldLock&& other) = delete;
    ~HeldLock() {
        if (file_) file_->release(byte_);
    }

  private:
    HeldLock(std::shared_ptr<LockFile> file, off_t byte) : file_(std::move(file)), byte_(byte) {}

    std::shared_ptr<LockFile> file_;
    off_t byte_ = 0;
};

}  // namespace macula::session
