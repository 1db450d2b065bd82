// Reads and checks everything in the study store, and repairs what is damaged.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "session/store.h"

namespace macula::live {

struct VerifiedStore {
    session::VerifyReport report;
    session::OpeningNotes notes;   // from the last opening: the database set aside, if any
    bool isRescuePending = false;  // another program has the damaged database open
    bool isSound() const { return report.isSound() && !notes.setAside; }
};

// Opens the store of `options`. Sets a damaged database aside and rescues what can be read of it; sets
// damaged models and rows aside, so that they are no longer found. Fails as Store::open and Store::verify.
Result<VerifiedStore> verifyStore(session::StoreOptions options, Progress& progress);

}  // namespace macula::live
