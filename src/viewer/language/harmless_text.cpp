#include "viewer/language/harmless_text.h"

namespace macula::viewer {

QString harmless(const QString& text) {
    QString line = text.simplified();
    line.removeIf([](QChar c) {
        const char16_t u = c.unicode();
        return c.category() == QChar::Other_Control || u == 0x200e || u == 0x200f ||
               (u >= 0x202a && u <= 0x202e) || (u >= 0x2066 && u <= 0x2069);
    });
    return line;
}

}  // namespace macula::viewer
