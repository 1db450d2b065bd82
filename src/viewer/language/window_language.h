// Texts of the layers without Qt, in the language of the window.
#pragma once

#include <QString>
#include <QStringList>
#include <string>
#include <vector>

#include "base/message.h"
#include "base/result.h"

namespace macula::viewer {

// Looks up the format of a text in the context "core" of translations/macula_*.ts, and inserts its arguments
// there: texts in the language of the window, numbers with its decimal sign, words from files unchanged. A
// format without an entry stays English.
QString inWindowsLanguage(const Text& text);
QStringList inWindowsLanguage(const std::vector<Text>& texts);

// Message and hint, or sentence and action, in one line, without the path of an error.
QString inWindowsLanguage(const Error& error);
QString inWindowsLanguage(const Message& message);

// The title of a built-in preset, clip, light rig, look or quality; other titles stay. Titles have a context
// of their own, so that no text of a file is translated by mistake.
QString titleInWindowsLanguage(const std::string& title);

// "12.5 mm" with the decimal sign of the window's language. Only for Macula's own texts: digits in the text
// of a file need not be a number.
QString withLocalNumbers(QString text);

}  // namespace macula::viewer
