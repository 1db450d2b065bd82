// Texts of the rooms below, in the language of the window.
#pragma once

#include <QString>
#include <string>

#include "base/message.h"
#include "base/result.h"

namespace macula::viewer {

// Errors, messages, stages of work, and titles of what is built in come in English from rooms that know no
// Qt. They are looked up by their text in translations/core_de.ts, in which %1 to %9 stand for what a
// program puts into a sentence; in those of the context "labels" it is text of a file, and stays. A text that
// is not there, such as one of somebody else's, stays as it is; of several sentences each is looked up by
// itself. On the UI thread.
QString inWindowsLanguage(const QString& text);
QString inWindowsLanguage(const std::string& text);

// Facts in a row, each by itself; what stands between them, as it is.
QString listInWindowsLanguage(const std::string& facts, const QString& between = QStringLiteral(", "));

// Of a preset, a clip, a light rig, a look or a quality. Only what is built in has another one: the words of
// titles are in no sentence, so that no text of a file is ever taken for one.
QString titleInWindowsLanguage(const std::string& title);

// Message and hint, or sentence and action, in one line. The path of an error is not in it.
QString inWindowsLanguage(const Error& error);
QString inWindowsLanguage(const Message& message);

// "12.5 mm" with the decimal sign of the window's language. For text of Macula only: in one of a file, what
// looks like a number may be none.
QString withLocalNumbers(QString text);

// Reads such a file; where there is none, as for English, all texts stay as they are. The decimal sign is
// that of QLocale() then; before, it is a point.
void useCoreWords(const QString& path);

}  // namespace macula::viewer
