// Keeps others out, be they other programs or other parts of this one.
#pragma once

#include <filesystem>

namespace macula {

// A lock ends with the object, or with its program, however that ends.
class FileLock {
  public:
    // Creates the file (0600) if it is missing; its folder must be there.
    explicit FileLock(const std::filesystem::path& file);
    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&&) = delete;
    ~FileLock();

    // Whether the file could be opened: otherwise nobody's lock is known of.
    bool isThere() const { return descriptor_ >= 0; }
    // Takes the lock if nobody else has it. Whether it is ours now.
    bool isOurs() const;
    // Whether nobody else has it at this moment; takes nothing.
    bool isFree() const;

  private:
    int descriptor_ = -1;
};

}  // namespace macula
