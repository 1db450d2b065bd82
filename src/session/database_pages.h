// Extracts rows from the bytes of a damaged database, without SQLite: from every page that looks like a leaf
// of a table, referenced or not. Format: sqlite.org/fileformat2.html, sections 1.6 and 2.1.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "session/rows.h"

namespace macula::session {

struct FoundRow {
    const Table* table = nullptr;
    Row row;
};

// The rows whose checksum fits one of our tables. A row may occur twice, and in more than one version. Any
// bytes may be passed.
std::vector<FoundRow> rowsInPages(std::span<const std::byte> file);

}  // namespace macula::session
