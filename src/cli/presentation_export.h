// macula export PATH --presentation-state FILE: a 3D view as a DICOM object, for archives.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <filesystem>
#include <string>

#include "base/result.h"
#include "dicom/scan.h"
#include "pictures/state_request.h"

namespace macula::cli {

struct PresentationExportRequest {
    std::filesystem::path output;  // empty: not asked for
    pictures::StateRequest state;
    bool isDeidentified = false;
};

// The series that it is of.
struct PresentedStudy {
    std::filesystem::path path;
    std::string series;
    std::size_t volume = 0;
    dicom::ScanOptions how;
    bool overwrite = false;
};

// --presentation-state, which is returned, and what needs it. `options` must outlive the parsing.
CLI::Option* addPresentation(CLI::App& command, PresentationExportRequest& options);

Result<void> exportPresentation(const PresentationExportRequest& options, const PresentedStudy& study);

}  // namespace macula::cli
