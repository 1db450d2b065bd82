#include "cli/shared/study_options.h"

#include <CLI/App.hpp>
#include <CLI/Option.hpp>

namespace macula::cli {

void addJoin(CLI::App& command, dicom::ScanOptions& how) {
    command.add_flag(
        "--join", how.join,
        "Take images for one series that agree in all but identifiers made anew for each of them");
}

void addStudyAsOfRender(CLI::App& command, std::filesystem::path& path, std::string& series,
                        dicom::ScanOptions& how) {
    command.add_option("PATH", path, "As of render (default: the phantom)");
    command.add_option("--series", series, "As of render");
    addJoin(command, how);
}

void addSavedView(CLI::App& command, std::filesystem::path& savedView) {
    command
        .add_option("--session", savedView,
                    "View that the window saved of this series: drawn as it says, but for what is given "
                    "besides")
        ->option_text("FILE");
}

}  // namespace macula::cli
