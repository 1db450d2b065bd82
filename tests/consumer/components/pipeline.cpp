// A transfer function from text, and the devices of this machine.
#include <pipeline/gpu/device.h>
#include <pipeline/volume/transfer_function_json.h>

#include "ends.h"

int main() {
    if (macula::transferFunctionFromJson("{}", "nowhere", {})) return expect(false, "{} is no preset");
    auto instance = macula::gpu::Instance::create();
    if (!instance) return fail(instance.error());
    const auto device = macula::gpu::Device::create(*instance);
    if (!device) return fail(device.error());
    return expect((*device)->memoryAvailableBytes() > 0, "a device with memory");
}
