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
    macula::live::DeviceWay way;  // in which it was opened, for who opens it once more
    macula::gpu::LastingDevice lasting;
    // Of devices that were lost and replaced since the last picture was begun.
    std::shared_ptr<std::vector<std::string>> told;
    macula::c::LastScene lastScene = {};  // last: it is on the device
};
