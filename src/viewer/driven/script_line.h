// The command line of macula-viewer-bench.
#pragma once

#include <QString>
#include <QStringList>

#include "base/result.h"
#include "viewer/program/command_line.h"

namespace macula::viewer {

struct ScriptLine {
    // `session` itself starts `opening`.
    enum class Script { orbit, changes, session, opening, stations } script = Script::orbit;
    CommandLine window;
    QString screenshots;
    QString lastStation;       // of the script `stations`; empty: all
    bool namesPatient = true;  // on screen; in screenshots only on request
    double waitSeconds = 0.0;
    double turnSeconds = 8.0;
    double seconds = 8.0;
    double restSeconds = 300.0;
};

// `arguments` begins with the program's name. Fails with usage. Where `window` has a text to print, nothing
// else was read.
Result<ScriptLine> parseScriptLine(const QStringList& arguments);

}  // namespace macula::viewer
