// Copies bytes between host and device, for set-up and for results. In a frame loop, record the copies
// instead (recorder.h).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/check.h"
#include "base/result.h"
#include "pipeline/gpu/resources.h"

namespace macula::gpu {

// Writes into [offsetBytes, offsetBytes + bytes.size()), after all work submitted so far and before all work
// submitted later; `bytes` may be dropped on return. Writes directly if the buffer is mapped and the device
// idle, else copies chunks of 16 MiB. For device-local buffers, offsetBytes and the number of bytes must be
// multiples of 4.
Result<void> uploadTo(const Buffer& buffer, std::uint64_t offsetBytes, std::span<const std::byte> bytes);

// Writes the whole image, tightly packed: bytes.size() must be image.bytes().
Result<void> uploadTo(const Image& image, std::span<const std::byte> bytes);

template <class T>
Result<void> uploadTo(const Buffer& buffer, std::span<const T> values) {
    return uploadTo(buffer, 0, std::as_bytes(values));
}

// These read bytes back after all work submitted so far, and wait for it.
Result<std::vector<std::byte>> readBytes(const Buffer& buffer, std::uint64_t offsetBytes,
                                         std::uint64_t bytes);
Result<std::vector<std::byte>> readBytes(const Image& image);

Result<void> readInto(const Buffer& buffer, std::uint64_t offsetBytes, std::span<std::byte> target);
Result<void> readInto(const Image& image, std::span<std::byte> target);

template <class T>
Result<std::vector<T>> read(const Buffer& buffer) {
    MACULA_CHECK_EQ(buffer.bytes() % sizeof(T), 0u);
    std::vector<T> values(buffer.bytes() / sizeof(T));
    MACULA_TRY_VOID(readInto(buffer, 0, std::as_writable_bytes(std::span(values))));
    return values;
}

template <class T>
Result<std::vector<T>> read(const Image& image) {
    MACULA_CHECK_EQ(image.bytes() % sizeof(T), 0u);
    std::vector<T> values(image.bytes() / sizeof(T));
    MACULA_TRY_VOID(readInto(image, std::as_writable_bytes(std::span(values))));
    return values;
}

}  // namespace macula::gpu
