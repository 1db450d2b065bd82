// An open file of the system, owned: what others give as a number is duplicated, and theirs stays open.
#pragma once

#include <utility>

#include "base/result.h"

namespace macula::gpu {

class FileDescriptor {
  public:
    FileDescriptor() = default;  // none
    // Of its own, for the same file; not inherited by programs that are started. usage when there is none
    // such.
    static Result<FileDescriptor> copyOf(int descriptor);

    FileDescriptor(FileDescriptor&& other) noexcept : descriptor_(other.release()) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    ~FileDescriptor();

    explicit operator bool() const { return descriptor_ >= 0; }
    int get() const { return descriptor_; }
    // From here on somebody else closes it.
    int release() { return std::exchange(descriptor_, -1); }

  private:
    explicit FileDescriptor(int owned) : descriptor_(owned) {}

    int descriptor_ = -1;
};

}  // namespace macula::gpu
