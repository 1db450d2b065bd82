// Images that a host has on another device of the card that draws.
#include "c/shared_image.h"

#include <algorithm>
#include <utility>

#include "c/handles.h"
#include "c/last_error.h"
#include "c/sized.h"

namespace macula::c {

namespace {

gpu::SharedMemoryHandles optionsOf(const macula_shared_memory& given) {
    gpu::SharedMemoryHandles options;
    options.memory = given.memory_fd;
    options.wait = given.wait_fd;
    options.signal = given.signal_fd;
    std::copy_n(given.device_uuid, options.card.device.size(), options.card.device.begin());
    std::copy_n(given.driver_uuid, options.card.driver.size(), options.card.driver.begin());
    options.bytes = given.bytes;
    options.offsetBytes = given.offset;
    options.memoryType = given.memory_type;
    options.isDedicated = given.is_dedicated != 0;
    // Numbers below 0 become impossibly large, and are refused.
    options.width = std::uint32_t(given.width);
    options.height = std::uint32_t(given.height);
    options.format = std::uint32_t(given.format);
    options.tiling = std::uint32_t(given.tiling);
    options.usage = given.usage;
    options.flags = given.flags;
    options.layout = std::uint32_t(given.layout);
    return options;
}

}  // namespace

extern "C" {

macula_status macula_shared_image_create(const macula_shared_memory* memory, macula_shared_image** image) {
    if (image != nullptr) *image = nullptr;
    return guarded([&]() -> Result<void> {
        if (memory == nullptr || image == nullptr) return nullHandle();
        MACULA_TRY(const macula_shared_memory given, taken(memory));
        MACULA_TRY(gpu::SharedMemory shared, gpu::SharedMemory::create(optionsOf(given)));
        auto made = std::make_unique<macula_shared_image>();
        made->memory = std::make_shared<const gpu::SharedMemory>(std::move(shared));
        *image = opened(std::move(made));
        return {};
    });
}

void macula_shared_image_close(macula_shared_image* image) {
    close(image);
}

}  // extern "C"

}  // namespace macula::c
