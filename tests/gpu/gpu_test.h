// The fixture of all tests that need a device: validation on where it is installed, and not one message of it
// at the end of any test.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>

#include "gpu/validation.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/instance.h"

namespace macula::gpu {

// Fails the test with the error's sentence, then aborts it.
template <class T>
T expectOk(Result<T> result) {
    if (!result.ok()) {
        ADD_FAILURE() << result.error().message << " " << result.error().hint;
        throw std::runtime_error(result.error().message.english());
    }
    return std::move(*result);
}

inline void expectOk(Result<void> result) {
    if (!result.ok()) ADD_FAILURE() << result.error().message << " " << result.error().hint;
}

class GpuTest : public ::testing::Test {
  protected:
    void SetUp() override {
        instance_ = expectOk(Instance::create({.validation = validationOfTests()}));
        device_ = expectOk(Device::create(*instance_));
    }

    void TearDown() override {
        if (!instance_) return;
        if (device_) expectOk(device_->waitForAll());
        device_.reset();  // objects left behind are reported when the device goes
        for (const std::string& message : instance_->validationMessages()) ADD_FAILURE() << message;
    }

    const std::shared_ptr<Device>& device() const { return device_; }

    std::optional<Instance> instance_;
    std::shared_ptr<Device> device_;
};

}  // namespace macula::gpu
