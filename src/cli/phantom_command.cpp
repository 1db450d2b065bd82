// macula phantom DIR: the built-in phantom as a DICOM series, to try other programs on or to test with.
#include <CLI/App.hpp>
#include <filesystem>
#include <memory>

#include "base/phantom.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/shared/interrupt.h"
#include "dicom/write/series_writer.h"

namespace macula::cli {

namespace {

Result<void> writePhantom(const std::filesystem::path& folder) {
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const auto files, dicom::writeSeries(phantom::make(), folder, {}, progress));
    fmt::print("Wrote {} files to {}\n", files.size(), folder.string());
    return {};
}

}  // namespace

void addPhantom(CLI::App& app, Action& action) {
    auto folder = std::make_shared<std::filesystem::path>();
    auto* command = app.add_subcommand("phantom", "Write the built-in CT phantom as a DICOM series");
    command->add_option("DIR", *folder, "Folder to write into; must be missing or empty")->required();
    command->callback([folder, &action] { action = [folder] { return writePhantom(*folder); }; });
}

}  // namespace macula::cli
