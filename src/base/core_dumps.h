// Memory of a program that ended, in a file: it holds images, and names of patients.
#pragma once

namespace macula {

// From here on neither this process nor those that it starts leave any: the limit of their size is 0, and
// where a service of the system takes them whatever the limit is (core(5)), no memory is in them.
// MACULA_CORE_DUMPS=1 in the environment leaves all as the system has it, for who looks for a fault.
void switchCoreDumpsOff();

}  // namespace macula
