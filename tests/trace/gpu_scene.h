// A tracer on the device, with validation on.
#pragma once

#include <gtest/gtest.h>

#include "pipeline/gpu/device.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::trace {

// One instance and device for the whole test program; every test ends without a word from the validation
// layer.
class DeviceTest : public ::testing::Test {
  protected:
    static gpu::Instance& instance() {
        static gpu::Instance made = [] {
            auto result = gpu::Instance::create(
                {.extensions = {}, .validation = gpu::Validation::on, .createInstance = {}});
            return std::move(result).value();
        }();
        return made;
    }
    static const std::shared_ptr<gpu::Device>& device() {
        static const std::shared_ptr<gpu::Device> made = *gpu::Device::create(instance());
        return made;
    }

    void TearDown() override { EXPECT_EQ(instance().validationMessageCount(), 0u); }

    static PathTracer tracer(const std::shared_ptr<const Volume>& volume, const TransferFunction& function,
                             const Environment& environment, const View& view, const Settings& settings) {
        auto made = PathTracer::create(device());
        PathTracer result = std::move(made).value();
        EXPECT_TRUE(result.setVolume(volume).ok());
        EXPECT_TRUE(result.setTransferFunction(function).ok());
        EXPECT_TRUE(result.setEnvironment(environment).ok());
        EXPECT_TRUE(result.setSettings(settings).ok());
        EXPECT_TRUE(result.setView(view).ok());
        return result;
    }
};

}  // namespace macula::trace
