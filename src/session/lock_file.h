// Locks between processes: bytes of one file, locked by open file descriptions (F_OFD_SETLK of Linux). A lock
// ends with its process, however that ends. Locks work on network drives that support them, and fail with
// noLocks on others.
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
    // Shared by each process that has the store open; exclusive to replace the database.
    static constexpr off_t kPresence = 0;
    // Shared to copy or open a blob; exclusive to remove blobs.
    static constexpr off_t kBlobs = 1;
    // The byte of an open model, from the digest of its key. Two keys may have the same byte; then one of the
    // models is kept longer than needed.
    static off_t byteOf(std::string_view keyDigest);

    // Creates the file (0600) if it is missing.
    static Result<std::shared_ptr<LockFile>> open(const std::filesystem::path& file);
    ~LockFile();
    LockFile(const LockFile&) = delete;
    LockFile& operator=(const LockFile&) = delete;

    // Waits at most `patience`, then fails with lockedByAnother; fails with noLocks at once. Changes a held
    // lock to the other kind. Locks of one LockFile do not exclude each other.
    Result<void> acquire(off_t byte, Hold hold, std::chrono::milliseconds patience);
    void release(off_t byte);

    // Locks the byte, shared and counted: it is released once all added marks are removed.
    Result<void> addMark(off_t byte);
    void removeMark(off_t byte);
    // Whether this store or another has marked the byte; true if that cannot be determined.
    bool isMarked(off_t byte);

  private:
    LockFile(std::filesystem::path file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}
    int set(off_t byte, int type);  // 0, or errno

    std::filesystem::path file_;
    int descriptor_ = -1;
    std::mutex mutex_;
    std::map<off_t, int> marks_;
};

// Holds a lock until it is destroyed.
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
