// A new store is empty.
#include <session/store.h>

#include "ends.h"

int main(int argc, char** argv) {
    macula::session::StoreOptions options;
    options.folder = std::filesystem::path(argc > 1 ? argv[1] : "made") / "sessions";
    std::filesystem::create_directories(options.folder.parent_path());
    auto store = macula::session::Store::open(options);
    if (!store) return fail(store.error());
    const auto studies = store->listStudies();
    if (!studies) return fail(studies.error());
    return expect(studies->entries.empty(), "no study yet");
}
