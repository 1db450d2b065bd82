// OpenXR 1.0 with Vulkan. Functions come from the loader at run time (loader.h): a program without it starts.
#pragma once

#include <vulkan/vulkan_core.h>

#define XR_NO_PROTOTYPES
#define XR_USE_GRAPHICS_API_VULKAN
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>
