// Texts of the layers without Qt, in the language of the window.
#pragma once

#include <QString>
#include <string>

#include "base/message.h"
#include "base/result.h"

namespace macula::viewer {

// Errors, messages, stages of work and built-in titles come in English from layers without Qt. They are
// looked up in translations/core_de.ts, in which %1 to %9 stand for inserted text; in the context "labels"
// inserted text comes from a file and is kept. Several sentences are looked up one by one. A text without an
// entry stays as it is. On the UI thread.
QString inWindowsLanguage(const QString& text);
QString inWindowsLanguage(const std::string& text);

// Translates each of the facts that `between` separates.
QString listInWindowsLanguage(const std::string& facts, const QString& between = QStringLiteral(", "));

// The title of a built-in preset, clip, light rig, look or quality; other titles stay. Titles have a context
// of their own, so that no text of a file is translated by mistake.
QString titleInWindowsLanguage(const std::string& title);

// Message and hint, or sentence and action, in one line, without the path of an error.
QString inWindowsLanguage(const Error& error);
QString inWindowsLanguage(const Message& message);

// "12.5 mm" with the decimal sign of the window's language. Only for Macula's own texts: digits in the text
// of a file need not be a number.
QString withLocalNumbers(QString text);

// Reads such a file; without one, as for English, all texts stay. Sets the decimal sign to that of QLocale();
// before the first call it is a point.
void useCoreWords(const QString& path);

}  // namespace macula::viewer
