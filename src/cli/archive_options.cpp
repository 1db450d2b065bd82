#include "cli/archive_options.h"

#include <utility>

namespace macula::cli {

void addArchive(CLI::App& command, ArchiveOptions& options) {
    command.add_option("ARCHIVE", options.archive, "Its name, as macula pacs list prints it")->required();
    command.add_flag("--json", options.json, "Print JSON");
}

Result<net::SourceList> readSourceList() {
    return net::SourceList::read(net::SourceFiles::ofUser());
}

Result<OpenArchive> openArchive(const ArchiveOptions& options) {
    MACULA_TRY(const net::SourceList list, readSourceList());
    MACULA_TRY(net::Source source, list.find(options.archive));
    MACULA_TRY(auto archive, net::archiveOf(list, source));
    return OpenArchive{std::move(source), std::move(archive)};
}

}  // namespace macula::cli
