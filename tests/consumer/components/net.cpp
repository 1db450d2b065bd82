// An archive that is not there.
#include <net/connect.h>

#include "ends.h"

int main() {
    const macula::net::Source source{
        .name = "nowhere",
        .peer = macula::net::DimsePeer{.host = "localhost", .port = 1, .calledAe = "NOBODY"}};
    auto archive = macula::net::archiveOf(source, {});
    if (!archive) return fail(archive.error());
    macula::Progress progress;
    const auto found = (*archive)->findStudies({}, progress);
    return expect(!found && found.error().code == macula::ErrorCode::archiveNotUsable,
                  "it says that nobody answers");
}
