// Which archive a verb speaks with.
#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <string>

#include "net/connect.h"
#include "net/sources/source_list.h"

namespace macula::cli {

struct ArchiveOptions {
    std::string archive;  // its name in the list
    bool json = false;
};

// The name of the archive and --json.
void addArchive(CLI::App& command, ArchiveOptions& options);

Result<net::SourceList> readSourceList();

struct OpenArchive {
    net::Source source;
    std::unique_ptr<net::Archive> archive;
};
Result<OpenArchive> openArchive(const ArchiveOptions& options);

}  // namespace macula::cli
