// Rows out of the bytes of a damaged database file, without SQLite: from every page that looks like a leaf of
// a table, whether or not anything leads to it. Format: sqlite.org/fileformat2.html, sections 1.6 and 2.1.
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

// Those whose checksum says that they are a row of one of our tables. The same row may be found twice, and
// more than one version of it. Any bytes may be passed.
std::vector<FoundRow> rowsInPages(std::span<const std::byte> file);

}  // namespace macula::session
