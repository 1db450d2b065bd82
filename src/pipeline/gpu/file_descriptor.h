// An owned file descriptor. Descriptors of other owners are duplicated, so theirs stay open.
#pragma once

#include <utility>

#include "base/result.h"

namespace macula::gpu {

class FileDescriptor {
  public:
    FileDescriptor() = default;  // owns nothing
    // Duplicates the descriptor; child processes do not inherit the copy. Fails with usage when `descriptor`
    // is not open.
    static Result<FileDescriptor> copyOf(int descriptor);

    FileDescriptor(FileDescriptor&& other) noexcept : descriptor_(other.release()) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    ~FileDescriptor();

    explicit operator bool() const { return descriptor_ >= 0; }
    int get() const { return descriptor_; }
    // Gives up ownership: the caller closes it.
    int release() { return std::exchange(descriptor_, -1); }

  private:
    explicit FileDescriptor(int owned) : descriptor_(owned) {}

    int descriptor_ = -1;
};

}  // namespace macula::gpu
