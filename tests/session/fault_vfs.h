// A file layer of SQLite that fails on demand, over that of the system.
//
// Writes, truncations and syncs are counted, or reads. When the one with the number that was set comes, the
// fault happens. What was written since the last sync of a file is known, so that a power cut can take it
// away again: each sector of 512 bytes is then as it was synced, as it was written, or torn between the two.
#pragma once

#include <cstdint>

namespace macula::session::test {

enum class Fault {
    none,
    ioError,     // that one fails, and nothing is written
    shortWrite,  // half of it is written, then the disk is full, for this one
    diskFull,    // that write and all later ones
    tornWrite,   // half of it is written, and all later ones fail
    powerCut,    // nothing works any more
    readError,   // that read fails; reads are counted instead of writes
};

// The name for StoreOptions::vfs.
inline constexpr const char* kFaultVfs = "macula-faults";

// Counts from 1, anew. Files that are open go on.
void setFault(Fault fault, int at, std::uint32_t seed);
// How many there were since; none are counted without a fault.
int operationCount();
// Whether the fault has happened.
bool hasFailed();
// After a power cut, when everything is closed: files are as the disk might have them.
void loseUnsynced();

}  // namespace macula::session::test
