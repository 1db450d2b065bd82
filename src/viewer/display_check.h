// Whether there is a display, before Qt looks for one.
#pragma once

namespace macula::viewer {

// Qt ends the process with an abort where no display answers; a sentence is kinder. Needs no QApplication.
bool hasDisplay();

}  // namespace macula::viewer
