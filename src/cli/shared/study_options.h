// Options of the verbs that read a study.
#pragma once

#include <filesystem>
#include <string>

#include "dicom/scan.h"

namespace CLI {
class App;
}

namespace macula::cli {

// --join, of every verb that reads a folder.
void addJoin(CLI::App& command, dicom::ScanOptions& how);

// PATH, --series and --join, of verbs that do something else with it.
void addStudyAsOfRender(CLI::App& command, std::filesystem::path& path, std::string& series,
                        dicom::ScanOptions& how);

// --session: what pictures::StateRequest begins with.
void addSavedView(CLI::App& command, std::filesystem::path& savedView);

}  // namespace macula::cli
