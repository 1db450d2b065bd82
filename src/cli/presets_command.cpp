// macula presets: the built-in transfer functions and light rigs, and presets of other programs as ours.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "cli/command.h"
#include "cli/shared/json_text.h"
#include "cli/shared/output_options.h"
#include "cli/shared/report.h"
#include "pictures/output_files.h"
#include "pipeline/volume/transfer_function_json.h"
#include "presets/preset_file.h"
#include "scene/choice/built_in_list.h"
#include "scene/choice/preset_choice.h"

namespace macula::cli {

namespace {

struct PresetsOptions {
    bool json = false;
    std::string preset;            // show, export
    std::filesystem::path input;   // import
    std::filesystem::path output;  // import, export
    bool overwrite = false;        // likewise
};

Result<void> listAll(const PresetsOptions& options) {
    MACULA_TRY(const scene::BuiltIns all, scene::builtIns());
    if (options.json) {
        fmt::print("{}\n", jsonText(toJson(all)));
        return {};
    }
    fmt::print("Presets (--preset NAME or NUMBER)\n");
    for (const TransferFunction& preset : all.presets) {
        fmt::print("  {:>3}  {:<28}{:<8}{:<11}{}\n", preset.number.value_or(0), preset.name,
                   fmt::join(preset.modalities, ", "), preset.source, preset.title);
    }
    fmt::print("Lights (--lights)\n");
    for (const trace::LightRig& rig : all.lights) fmt::print("       {:<28}{}\n", rig.name, rig.title);
    fmt::print("Clips (--clip)\n");
    for (const ClipPreset& clip : all.clips) fmt::print("       {:<28}{}\n", clip.name, clip.title);
    fmt::print("Qualities (--quality)\n");
    for (const trace::Quality& quality : all.qualities) {
        fmt::print("       {:<28}{} samples, {} bounces{}\n", quality.name, quality.samplesPerPixel,
                   quality.bounces, quality.denoising == trace::Denoising::on ? ", denoised" : "");
    }
    return {};
}

void printOpacity(std::string_view title, const std::vector<OpacityPoint>& points) {
    fmt::print("{}\n", title);
    for (const OpacityPoint& point : points) {
        fmt::print("  {:>12.9g}  {:<9.6g}", point.value, point.opacity);
        if (point.midpoint != 0.5 || point.sharpness != 0.0)
            fmt::print("  midpoint {:g}, sharpness {:g}", point.midpoint, point.sharpness);
        fmt::print("\n");
    }
}

void printColour(const std::string& title, const std::vector<ColourPoint>& points) {
    fmt::print("{}\n", title);
    for (const ColourPoint& point : points) {
        fmt::print("  {:>12.9g}  {:.6g} {:.6g} {:.6g}\n", point.value, point.colour.r, point.colour.g,
                   point.colour.b);
    }
}

Result<void> show(const PresetsOptions& options) {
    MACULA_TRY(const presets::ImportedPreset chosen, scene::choosePreset(options.preset));
    const TransferFunction& preset = chosen.function;
    for (const Text& note : chosen.notes) printNote(note);
    if (options.json) {
        fmt::print("{}", toJson(preset));
        return {};
    }
    fmt::print("{} ({})\n", preset.title, preset.name);
    if (preset.number) fmt::print("number             {}\n", *preset.number);
    fmt::print("source             {}\n", preset.source.empty() ? "unknown" : preset.source);
    fmt::print("modality           {}\n", fmt::join(preset.modalities, ", "));
    fmt::print("values             {}\n", scene::unitOf(preset));
    if (preset.effectiveRange)
        fmt::print("effective range    {:g} to {:g}\n", preset.effectiveRange->low,
                   preset.effectiveRange->high);
    if (preset.fitToVolume) fmt::print("fitted             to each volume\n");
    if (const Surface& surface = preset.surface; surface.weight > 0.0)
        fmt::print(
            "surface            weight {:g}, half of it at {:g} per mm, roughness {:g}, reflectance {:g}\n",
            surface.weight, surface.gradientPerMm, surface.roughness, surface.reflectance);
    if (usesSteepCurves(preset))
        fmt::print("steep matter       half of it at {:g} per mm\n", preset.steep.gradientPerMm);
    printOpacity("opacity of " + fmt::format("{:g} mm", preset.unitDistanceMm), preset.opacity);
    if (!preset.gradientOpacity.empty())
        printOpacity("gradient opacity (units per voxel)", preset.gradientOpacity);
    const std::string space = fmt::format("({})", colourSpaceName(preset.colourSpace));
    printColour("colour " + space, preset.colour);
    if (!usesSteepCurves(preset)) return {};
    printOpacity("opacity of steep matter", preset.steep.opacity);
    printColour("colour of steep matter " + space, preset.steep.colour);
    return {};
}

Result<void> importFile(const PresetsOptions& options) {
    MACULA_TRY(const presets::ImportedPresets all, presets::readPresetFile(options.input));
    std::error_code error;
    const bool toFolder = std::filesystem::is_directory(options.output, error);
    if (!toFolder && all.size() > 1) {
        return Error{
            ErrorCode::usage, Text("The file holds {} presets.", all.size()), options.input.string(),
            Text("Give -o a folder that exists, for one file each; or choose one: macula presets export "
                 "FILE#NAME -o FILE.json.")};
    }
    pictures::OutputFiles files(options.overwrite);
    files.read(options.input);
    for (const presets::ImportedPreset& preset : all) {
        for (const Text& note : preset.notes) printNote(preset.function.title + ": " + note.english());
    }
    std::vector<std::pair<std::filesystem::path, std::string>> texts;
    for (const TransferFunction& function : scene::withDifferentNames(all)) {
        texts.emplace_back(toFolder ? options.output / (function.name + ".json") : options.output,
                           toJson(function));
        MACULA_TRY_VOID(files.write(texts.back().first));
    }
    for (const auto& [path, text] : texts) MACULA_TRY_VOID(writeTextAtomically(path, text));
    return {};
}

Result<void> exportPreset(const PresetsOptions& options) {
    MACULA_TRY(const presets::ImportedPreset chosen, scene::choosePreset(options.preset));
    for (const Text& note : chosen.notes) printNote(note);
    pictures::OutputFiles files(options.overwrite);
    files.read(options.preset);
    MACULA_TRY_VOID(files.write(options.output));
    return writeTextAtomically(options.output, toJson(chosen.function));
}

}  // namespace

void addPresets(CLI::App& app, Action& action) {
    auto options = std::make_shared<PresetsOptions>();
    PresetsOptions& o = *options;
    auto* command = app.add_subcommand("presets", "List, show and convert presets; list lights");
    command->add_flag("--json", o.json, "Print JSON");
    command->require_subcommand(0, 1);
    command->callback([options, &action] {
        if (!action) action = [options] { return listAll(*options); };
    });

    auto* list = command->add_subcommand("list", "Built-in presets and lights; the same as no verb");
    list->add_flag("--json", o.json, "Print JSON");
    list->callback([options, &action] { action = [options] { return listAll(*options); }; });

    const std::string which = "Name or number, or file; FILE#NAME when it holds several";
    auto* one = command->add_subcommand("show", "The numbers of a preset");
    one->add_option("PRESET", o.preset, which)->required();
    one->add_flag("--json", o.json, "Print it as export writes it");
    one->callback([options, &action] { action = [options] { return show(*options); }; });

    auto* from =
        command->add_subcommand("import", "Convert a file of 3D Slicer, ParaView, VolView, MITK or Horos");
    from->add_option("FILE", o.input, "presets.xml, .mrml, .vp, .vp.json, .json, .xml, .plist")->required();
    from->add_option("-o,--output", o.output, "JSON file, or folder that gets a file for each preset")
        ->required();
    addOverwrite(*from, o.overwrite);
    from->callback([options, &action] { action = [options] { return importFile(*options); }; });

    auto* to = command->add_subcommand("export", "Write a preset as JSON that 3D Slicer reads too");
    to->add_option("PRESET", o.preset, which)->required();
    to->add_option("-o,--output", o.output, "JSON file to write")->required();
    addOverwrite(*to, o.overwrite);
    to->callback([options, &action] { action = [options] { return exportPreset(*options); }; });
}

}  // namespace macula::cli
