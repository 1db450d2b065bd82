// One instance and device for a whole test program, with validation on where it is installed. gpu_test.h has
// one for each test.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "gpu/validation.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/instance.h"

namespace macula::gpu {

// Every test ends without a word from the validation layer.
class SharedDeviceTest : public ::testing::Test {
  protected:
    static Instance& instance() {
        static Instance made = [] {
            auto result =
                Instance::create({.extensions = {}, .validation = validationOfTests(), .createInstance = {}});
            return std::move(result).value();
        }();
        return made;
    }
    static const std::shared_ptr<Device>& device() {
        static const std::shared_ptr<Device> made = *Device::create(instance());
        return made;
    }

    void TearDown() override {
        // What is still under way belongs to this test. At the program's exit it would be too late: the
        // driver's compiler goes then, and lavapipe compiles a kernel when it first runs.
        vkDeviceWaitIdle(device()->handle());
        EXPECT_EQ(instance().validationMessageCount(), 0u);
    }
};

}  // namespace macula::gpu
