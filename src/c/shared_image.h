// What a macula_shared_image is.
#pragma once

#include <macula.h>

#include <memory>

#include "pipeline/gpu/shared_memory.h"

struct macula_shared_image {
    std::shared_ptr<const macula::gpu::SharedMemory> memory;
};
