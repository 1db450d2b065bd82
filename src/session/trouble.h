// What can go wrong with stored sessions: each has a sentence of its own, and what to do. None of them names
// a patient or a path; the path is Error::where.
#pragma once

#include <filesystem>
#include <optional>

#include "base/result.h"

namespace macula::session {

enum class Trouble {
    readOnly,         // the folder or the file may not be written
    diskFull,         // no space, or the quota is used up
    noLocks,          // the file system cannot lock files, as some network drives
    lockedByAnother,  // another process has held the lock longer than was waited
    damaged,          // the database is no longer what was written
    newerSchema,      // a newer version of the program wrote it
    notOurs,          // a file or folder of somebody else stands there
    diskError,        // reading or writing failed
    noMemory,
    modelDamaged,     // a blob or its row is not what was saved
    modelTooLarge,    // one blob alone is above the cap
    modelGone,        // removed since it was looked up
    documentDamaged,  // its row is not what was saved
    documentInvalid,  // what is to be saved is no JSON object, too long or too deep, or has no usable name
    snapshotInvalid,  // what is to be imported is no snapshot
    purgeIncomplete,  // deleted, but bytes may still lie in a file that another process reads
};
inline constexpr int kTroubles = 16;

Error errorOf(Trouble trouble, const std::filesystem::path& where);

// Which of them an error of this room is; nothing for errors of other rooms.
std::optional<Trouble> troubleOf(const Error& error);

// Of an errno that open, mkdir, write or fsync left.
Trouble troubleOfErrno(int reason);

}  // namespace macula::session
