#include "c/device.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "c/handles.h"
#include "c/last_error.h"
#include "c/sized.h"
#include "pipeline/gpu/instance.h"
#include "pipeline/gpu/shared_memory.h"

namespace macula::c {

namespace {

Result<macula_device*> deviceOf(live::DeviceWay way) {
    auto told = std::make_shared<std::vector<std::string>>();
    MACULA_TRY(gpu::Instance instance, gpu::Instance::create(way.instance));
    MACULA_TRY(gpu::LastingDevice lasting,
               gpu::LastingDevice::open(std::move(instance), way.device, [told](const Text& sentence) {
                   told->push_back(sentence.english());
               }));
    return opened(std::unique_ptr<macula_device>(
        new macula_device{std::move(way), std::move(lasting), std::move(told)}));
}

Result<live::DeviceWay> wayOf(const macula_lent_device& lent) {
    live::LentHandles handles{.instance = lent.instance,
                              .physical = lent.physical_device,
                              .device = lent.device,
                              .queue = lent.queue,
                              .queueFamily = lent.queue_family};
    const auto calling = [user = lent.user](macula_queue_call call) -> std::function<void()> {
        if (call == nullptr) return {};
        return [call, user] { call(user); };
    };
    handles.lock = calling(lent.lock_queue);
    handles.unlock = calling(lent.unlock_queue);
    return lentWay(handles);
}

}  // namespace

extern "C" {

macula_status macula_device_open(const char* preferred, macula_device** device) {
    if (device != nullptr) *device = nullptr;
    return guarded([&]() -> Result<void> {
        if (device == nullptr) return nullHandle();
        live::DeviceWay way;
        if (preferred != nullptr) way.device.preferred = preferred;
        MACULA_TRY(*device, deviceOf(std::move(way)));
        return {};
    });
}

macula_status macula_device_lend(const macula_lent_device* lent, macula_device** device) {
    if (device != nullptr) *device = nullptr;
    return guarded([&]() -> Result<void> {
        if (lent == nullptr || device == nullptr) return nullHandle();
        MACULA_TRY(const macula_lent_device given, taken(lent));
        MACULA_TRY(live::DeviceWay way, wayOf(given));
        MACULA_TRY(*device, deviceOf(std::move(way)));
        return {};
    });
}

macula_status macula_device_identify(macula_device* device, macula_device_identity* identity) {
    return guarded([&]() -> Result<void> {
        MACULA_TRY(const Held<macula_device> of, changing(device));
        gpu::CardIdentity card;
        MACULA_TRY_VOID(of->lasting.run([&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
            card = gpu::identityOf(*on);
            return {};
        }));
        macula_device_identity told{};
        std::copy(card.device.begin(), card.device.end(), told.device_uuid);
        std::copy(card.driver.begin(), card.driver.end(), told.driver_uuid);
        return give(told, identity) ? Result<void>() : wrongSize(identity);
    });
}

void macula_device_close(macula_device* device) {
    close(device);
}

}  // extern "C"

}  // namespace macula::c
