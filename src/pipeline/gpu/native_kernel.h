// The twin of a shader that runs on the host's cores instead, on a device of type CPU.
//
// Such a device keeps buffers in host memory, so that the twin works on the same buffers, in the same order
// among other commands. Whoever records a dispatch need not know which of the two will run.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <vector>

namespace macula::gpu {

// What a dispatch gives the shader.
class NativeDispatch {
  public:
    NativeDispatch(std::array<std::uint32_t, 3> groups, std::span<const std::byte> push)
        : groups_(groups), push_(push.begin(), push.end()) {}

    // Work groups along each axis, of the shader's local size.
    const std::array<std::uint32_t, 3>& groups() const { return groups_; }
    void setGroups(const std::array<std::uint32_t, 3>& groups) { groups_ = groups; }

    // The push constants.
    template <class Push>
    Push push() const {
        Push value;
        std::memcpy(&value, push_.data(), sizeof(value));
        return value;
    }

    // The elements of the buffer or texel buffer at this binding number; of a view of a texel buffer, all
    // from the first of that view to the buffer's end.
    template <class T>
    std::span<T> binding(std::uint32_t number) const {
        const std::span<std::byte> bytes = bindings_[number];
        return {reinterpret_cast<T*>(bytes.data()), bytes.size() / sizeof(T)};
    }
    void bind(std::uint32_t number, std::span<std::byte> bytes) {
        if (bindings_.size() <= number) bindings_.resize(number + 1);
        bindings_[number] = bytes;
    }

  private:
    std::array<std::uint32_t, 3> groups_;
    std::vector<std::byte> push_;
    std::vector<std::span<std::byte>> bindings_;  // by number
};

// Does all of a dispatch, on any number of threads, and returns when it is done. May be called by any thread,
// one at a time. May throw std::bad_alloc, which becomes outOfMemory.
using NativeKernel = std::function<void(const NativeDispatch&)>;

}  // namespace macula::gpu
