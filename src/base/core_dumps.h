// Core dumps: files with the memory of a crashed program, which holds images and names of patients.
#pragma once

namespace macula {

// Stops core dumps of this process and of those that it starts: sets the limit of their size to 0, and leaves
// all memory out of those that a system service takes regardless of the limit (core(5)). MACULA_CORE_DUMPS=1
// in the environment keeps the system's settings, for debugging.
void switchCoreDumpsOff();

}  // namespace macula
