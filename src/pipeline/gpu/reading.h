// Reads bytes from the device to the host while the device and this thread do something else.
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

// Reads some buffers repeatedly. The thread that uses the device begins, finishes and drops it; any thread
// may read the parts between finish() and the next begin().
class Reading {
  public:
    Reading() = default;

    // Begins to copy the buffers as they are once all work submitted so far is done; later work may overwrite
    // them. All copies are one submission, to staging memory that is kept for the next time. If all buffers
    // are in host memory, or there is no staging memory, this reads them at once, and waits. The parts of the
    // previous reading are lost.
    Result<void> begin(std::initializer_list<const Buffer*> buffers);
    // Waits for the copies that begin() submitted. The next begin() waits for them too.
    Result<void> finish();

    // The bytes of the buffer at `index` of the list given to begin(), once it is finished.
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
    std::optional<Staging> staging_;  // the target of the copies
    std::vector<std::byte> own_;      // the target if they were read at once
    bool isOwn_ = false;
    std::shared_ptr<Device> device_;
    Ticket ticket_ = 0;  // 0: no copy is under way
};

}  // namespace macula::gpu
