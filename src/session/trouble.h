// The errors of stored sessions, each with its own sentence and advice. None of them names a patient or a
// path; the path is Error::where.
#pragma once

#include <filesystem>
#include <optional>

#include "base/result.h"

namespace macula::session {

enum class Trouble {
    readOnly,         // the folder or file may not be written
    diskFull,         // no space, or the quota is used up
    noLocks,          // the file system cannot lock files, like some network drives
    lockedByAnother,  // another process held the lock for too long
    damaged,          // the database is no longer what was written
    newerSchema,      // a newer version of the program wrote it
    notOurs,          // the file or folder belongs to another program
    diskError,        // reading or writing failed
    noMemory,
    modelDamaged,     // a blob or its row is not what was saved
    modelTooLarge,    // one blob alone is above the cap
    modelGone,        // removed since it was looked up
    documentDamaged,  // its row is not what was saved
    documentInvalid,  // not a JSON object, too long or too deep, or without a usable name
    snapshotInvalid,  // the folder to import is not a snapshot
    purgeIncomplete,  // the rows are deleted, but another process kept their bytes from being overwritten
};
inline constexpr int kTroubles = 16;

Error errorOf(Trouble trouble, const std::filesystem::path& where);

// The trouble of an error of this folder's functions; nothing for other errors.
std::optional<Trouble> troubleOf(const Error& error);

// The trouble of an errno from open, mkdir, write or fsync.
Trouble troubleOfErrno(int reason);

}  // namespace macula::session
