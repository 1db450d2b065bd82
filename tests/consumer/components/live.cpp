// The device that programs of Macula draw on.
#include <live/device/open_device.h>

#include "ends.h"

int main() {
    auto device = macula::live::openDevice("", {});
    if (!device) return fail(device.error());
    bool hasMemory = false;
    const auto used = device->run([&](const auto& lent) -> macula::Result<void> {
        hasMemory = lent->memoryAvailableBytes() > 0;
        return {};
    });
    if (!used) return fail(used.error());
    return expect(hasMemory, "a device with memory");
}
