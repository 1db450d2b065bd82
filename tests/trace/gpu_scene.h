// A tracer on the device, with validation on.
#pragma once

#include <gtest/gtest.h>

#include "gpu/shared_device.h"
#include "pipeline/trace/device_scene.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::trace {

class DeviceTest : public gpu::SharedDeviceTest {
  protected:
    static PathTracer tracer(const std::shared_ptr<const Volume>& volume, const TransferFunction& function,
                             const Environment& environment, const View& view, const Settings& settings) {
        return tracerOn(device(), volume, function, environment, view, settings);
    }
    static PathTracer tracerOn(const std::shared_ptr<gpu::Device>& on,
                               const std::shared_ptr<const Volume>& volume, const TransferFunction& function,
                               const Environment& environment, const View& view, const Settings& settings) {
        auto made = PathTracer::create(on);
        PathTracer result = std::move(made).value();
        EXPECT_TRUE(result.scene().setVolume(volume).ok());
        EXPECT_TRUE(result.scene().setTransferFunction(function).ok());
        EXPECT_TRUE(result.scene().setEnvironment(environment).ok());
        EXPECT_TRUE(result.setSettings(settings).ok());
        EXPECT_TRUE(result.setView(view).ok());
        return result;
    }
    // Where all kernels are shaders, also if the device is the CPU.
    static const std::shared_ptr<gpu::Device>& deviceOfShaders() {
        static const std::shared_ptr<gpu::Device> made =
            *gpu::Device::create(instance(), {.nativeKernels = false});
        return made;
    }
};

}  // namespace macula::trace
