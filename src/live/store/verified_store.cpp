#include "live/store/verified_store.h"

#include <utility>

namespace macula::live {

namespace {

Result<VerifiedStore> verifyOnce(const session::StoreOptions& options, Progress& progress) {
    MACULA_TRY(session::Store store, session::Store::open(options));
    MACULA_TRY(const session::VerifyReport report, store.verify(progress));
    return VerifiedStore{.report = report, .notes = store.notes()};
}

}  // namespace

Result<VerifiedStore> verifyStore(session::StoreOptions options, Progress& progress) {
    MACULA_TRY(VerifiedStore first, verifyOnce(options, progress));
    if (first.report.isDatabaseSound) return first;
    // Only a full check, which includes indexes, sets such a file aside on opening.
    options.check = session::StoreOptions::Check::full;
    auto second = verifyOnce(options, progress);
    if (second) {
        if (!second->notes.setAside) second->notes = first.notes;
        return second;
    }
    if (session::troubleOf(second.error()) != session::Trouble::lockedByAnother) return second.error();
    first.isRescuePending = true;
    return first;
}

}  // namespace macula::live
