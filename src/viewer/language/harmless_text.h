// Makes text from files, such as a patient's name, safe to paint.
#pragma once

#include <QString>

namespace macula::viewer {

// Returns one line without bidirectional control characters, which could make one name look like another.
QString harmless(const QString& text);

}  // namespace macula::viewer
