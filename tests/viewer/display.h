// A display for the tests of the window.
#pragma once

#include <string>

namespace macula::viewer::test {

// Makes sure that DISPLAY names an X server: the one that is there, else an Xvfb that ends with this process.
// Empty on success, else why there is none.
std::string ensureDisplay();

}  // namespace macula::viewer::test
