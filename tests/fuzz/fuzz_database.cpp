// Any bytes as a damaged database of sessions: what is rescued of it are whole rows of our tables, and there
// is no long search.
#include "fuzz/file_of_bytes.h"
#include "session/database_pages.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace macula::session;
    for (const FoundRow& found : rowsInPages(std::as_bytes(std::span(data, size)))) {
        MACULA_CHECK(found.table != nullptr);
        MACULA_CHECK(isSound(*found.table, found.row, rowCheck(found.table->name, found.row.values)));
    }
    return 0;
}
