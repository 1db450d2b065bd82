// Core dumps: files with the memory of a crashed program, which contains images and patient names.
#pragma once

namespace macula {

// Disables core dumps of this process and of its children: sets their size limit to 0, and excludes all
// memory from the dumps that a system service takes regardless of that limit (core(5)). MACULA_CORE_DUMPS=1
// in the environment keeps the system's settings, for debugging.
void switchCoreDumpsOff();

}  // namespace macula
