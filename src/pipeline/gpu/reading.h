// Bytes on their way from the device to the host, while the device and this thread do something else.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/check.h"
#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/gpu/staging_pool.h"

namespace macula::gpu {

// Reads some buffers again and again. Begun, finished and dropped by the thread that uses the device; what
// has come may be read by any thread, until it is begun again.
class Reading {
  public:
    Reading() = default;

    // Begins to copy what the buffers hold once all that is submitted by now is done; they may be written
    // over as soon as this returns. All copies are one submission, to staging memory that is kept for the
    // next time. Buffers in host memory are read here and now, which waits; likewise all where there is no
    // staging memory. What was read before is lost.
    Result<void> begin(std::initializer_list<const Buffer*> buffers);
    // Waits for what was begun; nothing else does.
    Result<void> finish();

    // Of the buffer at that place in the list, once it is finished.
    template <class T>
    std::span<const T> part(std::size_t index) const {
        const std::span<const std::byte> bytes = bytesOf(index);
        MACULA_CHECK_EQ(bytes.size() % sizeof(T), 0u);
        return {reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)};
    }

  private:
    struct Part {
        std::size_t offset = 0;
        std::size_t bytes = 0;
    };
    std::span<const std::byte> bytesOf(std::size_t index) const;
    Result<void> readNow(std::initializer_list<const Buffer*> buffers, std::size_t bytes);

    std::vector<Part> parts_;
    std::optional<Staging> staging_;  // where they come to
    std::vector<std::byte> own_;      // instead, where they were read at once
    bool isOwn_ = false;
    std::shared_ptr<Device> device_;
    Ticket ticket_ = 0;  // 0: all has come
};

}  // namespace macula::gpu
