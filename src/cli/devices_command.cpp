// macula devices: what Macula could draw with.
#include <CLI/App.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/shared/json_text.h"
#include "pipeline/gpu/device_info.h"
#include "pipeline/gpu/instance.h"

namespace macula::cli {

namespace {

struct DevicesOptions {
    bool json = false;
};

Result<void> listAll(const DevicesOptions& options) {
    MACULA_TRY(const gpu::Instance instance, gpu::Instance::create());
    const std::vector<gpu::DeviceInfo> devices = gpu::listDevices(instance);
    // Nothing is preferred here: the environment decides as it does in every other command.
    const auto chosen = gpu::chooseDevice(devices, {});
    if (devices.empty()) return chosen.ok() ? Result<void>() : Result<void>(chosen.error());

    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const gpu::DeviceInfo& device : devices) {
        const bool isChosen = chosen.ok() && chosen->index == device.index;
        if (options.json) {
            list.push_back({{"index", device.index},
                            {"name", device.name},
                            {"type", std::string(gpu::deviceTypeName(device.type))},
                            {"driver", device.driver},
                            {"memoryBytes", device.memoryBytes},
                            {"usable", device.usable()},
                            {"whyNotUsable", device.whyNotUsable.english()},
                            {"default", isChosen}});
            continue;
        }
        fmt::print(
            "{} {}  {}{}\n", isChosen ? '*' : ' ', device.index, gpu::describe(device),
            device.usable() ? "" : fmt::format("  (not usable: lacks {})", device.whyNotUsable.english()));
    }
    if (options.json) fmt::print("{}\n", jsonText(list));
    return {};
}

}  // namespace

void addDevices(CLI::App& app, Action& action) {
    auto options = std::make_shared<DevicesOptions>();
    auto* command =
        app.add_subcommand("devices", "List the devices Macula can draw with; * marks the default");
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &action] { action = [options] { return listAll(*options); }; });
}

}  // namespace macula::cli
