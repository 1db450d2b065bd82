// How a program of the window begins, and what it tells in the terminal.
#pragma once

#include <QApplication>
#include <QString>
#include <QStringList>
#include <memory>

#include "base/result.h"
#include "viewer/language/language.h"
#include "viewer/program/command_line.h"

namespace macula::viewer {

// First of all in main(): core dumps, memory, environment, and the program's name. Returns the arguments,
// which are read before there is an application object: --help and wrong options need no display.
QStringList startProgram(const char* name, const char* version, int argc, char** argv);

// Fails where there is no display. `argc` and `argv` are those of main().
Result<std::unique_ptr<QApplication>> openApplication(int& argc, char** argv);

// `otherwise`: the language where `line` has none.
void useLanguageAndTheme(QApplication& application, const CommandLine& line, Language otherwise);

// On standard error, in English, after the program's name. Returns the exit code.
int tellError(const Error& error);
void tellError(const QString& sentence);

}  // namespace macula::viewer
