// OpenXR 1.0 with Vulkan. The loader resolves functions at run time (runtime.h), so the program starts
// without it.
#pragma once

#include <vulkan/vulkan_core.h>

#define XR_NO_PROTOTYPES
#define XR_USE_GRAPHICS_API_VULKAN
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>
