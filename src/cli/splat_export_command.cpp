// macula splat-export MODEL -o FILE: a model of Gaussians in another format.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <chrono>
#include <filesystem>
#include <memory>

#include "cli/command.h"
#include "cli/shared/output_options.h"
#include "cli/shared/report.h"
#include "live/model/model_output.h"
#include "pictures/output_files.h"
#include "pipeline/splat/files/model_file.h"

namespace macula::cli {

namespace {

struct SplatExportOptions {
    std::filesystem::path model;
    std::filesystem::path output;
    bool displayColours = false;
    bool overwrite = false;
};

Result<void> exportModel(const SplatExportOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    MACULA_TRY_VOID(live::checkSplatsName(options.output));
    pictures::OutputFiles files(options.overwrite);
    files.read(options.model);
    MACULA_TRY_VOID(files.write(options.output));
    MACULA_TRY(const splat::ModelFile read, splat::readModel(options.model, splat::BadSplats::repair));
    if (read.repaired.dropped > 0)
        printNote(fmt::format("{} splats cannot be used; they were left out.", read.repaired.dropped));
    MACULA_TRY(const std::size_t limited,
               live::writeSplats(options.output, read.splats, options.displayColours));
    if (limited > 0)
        printNote(
            fmt::format("{} splats have numbers that this format cannot hold; they were limited.", limited));
    printWritten(options.output, start);
    return {};
}

}  // namespace

void addSplatExport(CLI::App& app, Action& action) {
    auto options = std::make_shared<SplatExportOptions>();
    SplatExportOptions& o = *options;
    auto* command = app.add_subcommand("splat-export", "Write a model of Gaussians in another format");
    command->add_option("MODEL", o.model, Text("A {} file", splat::modelExtensions(true)).english())
        ->required();
    command
        ->add_option("-o,--output", o.output,
                     "Model: .ply (exact), .spz (small) or .glb (glTF, KHR_gaussian_splatting)")
        ->required();
    command->add_flag("--display-colours", o.displayColours,
                      "Colours as displayed, for other programs: they do not know linear light and tone map");
    addOverwrite(*command, o.overwrite);
    command->callback([options, &action] { action = [options] { return exportModel(*options); }; });
}

}  // namespace macula::cli
