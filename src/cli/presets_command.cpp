// macula presets: the built-in transfer functions and light rigs.
#include <CLI/App.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/lights_choice.h"
#include "cli/preset_choice.h"

namespace macula::cli {

namespace {

struct Options {
    bool json = false;
};

Result<void> listAll(const Options& options) {
    MACULA_TRY(const std::vector<TransferFunction> presets, builtInPresets());
    MACULA_TRY(const std::vector<trace::LightRig> rigs, builtInLights());
    if (options.json) {
        nlohmann::ordered_json list = {{"presets", nlohmann::json::array()},
                                       {"lights", nlohmann::json::array()}};
        for (const TransferFunction& preset : presets) {
            list["presets"].push_back({{"name", preset.name},
                                       {"title", preset.title},
                                       {"modality", preset.modalities},
                                       {"unit", preset.unit == Unit::hounsfield ? "HU" : "raw"}});
        }
        for (const trace::LightRig& rig : rigs)
            list["lights"].push_back({{"name", rig.name}, {"title", rig.title}});
        fmt::print("{}\n", list.dump(4));
        return {};
    }
    fmt::print("Presets (--preset)\n");
    for (const TransferFunction& preset : presets) {
        fmt::print("  {:<22}{} ({})\n", preset.name, preset.title, fmt::join(preset.modalities, ", "));
    }
    fmt::print("Lights (--lights)\n");
    for (const trace::LightRig& rig : rigs) fmt::print("  {:<22}{}\n", rig.name, rig.title);
    return {};
}

}  // namespace

void addPresets(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    auto* command = app.add_subcommand("presets", "List the built-in presets and lights");
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &action] { action = [options] { return listAll(*options); }; });
}

}  // namespace macula::cli
