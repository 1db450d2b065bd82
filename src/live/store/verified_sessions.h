// Everything that is stored, read and checked, and put in order where it was damaged.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "session/store.h"

namespace macula::app {

struct VerifiedSessions {
    session::VerifyReport report;
    session::OpeningNotes notes;   // of the last opening: what was set aside, if the database had to be
    bool isRescuePending = false;  // the damaged database could not be replaced: another program has it open
    bool isSound() const { return report.isSound() && !notes.setAside; }
};

// Opens the store of `options`. A damaged database is set aside, and what can be read of it is rescued;
// models and rows that are damaged are set aside too, and found no more. Fails as Store::open and
// Store::verify do.
Result<VerifiedSessions> verifySessions(session::StoreOptions options, Progress& progress);

}  // namespace macula::app
