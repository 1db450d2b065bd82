// A device for the tests of the splats' kernels, with validation on.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "pipeline/gpu/device.h"
#include "pipeline/gpu/instance.h"

namespace macula::splat {

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
};

}  // namespace macula::splat
