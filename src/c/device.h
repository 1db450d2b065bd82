// What a macula_device is.
#pragma once

#include <macula.h>

#include <memory>
#include <string>
#include <vector>

#include "c/kept_scene.h"
#include "live/hosted/lent_handles.h"
#include "pipeline/gpu/recovery.h"

struct macula_device {
    macula::live::DeviceWay way;  // how it was opened, for a live picture that opens it again
    macula::gpu::LastingDevice lasting;
    // Sentences on devices that were lost and replaced since the last picture was begun.
    std::shared_ptr<std::vector<std::string>> told;
    macula::c::LastScene lastScene = {};  // last, because it uses the device
};
