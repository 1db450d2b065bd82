// Text of files, such as a patient's name, made safe to be painted.
#pragma once

#include <QString>

namespace macula::viewer {

// One line, without characters that turn the direction of what follows: they could make one name look like
// another.
QString harmless(const QString& text);

}  // namespace macula::viewer
