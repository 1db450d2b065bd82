// What the command line says of the window, and how its work is kept when the program is asked to end.
#pragma once

#include "viewer/window/main_window.h"  // before Qt, see vulkan_window.h

#include <QApplication>
#include <filesystem>
#include <optional>

#include "viewer/program/command_line.h"
#include "viewer/program/quit_signals.h"

namespace macula::viewer {

// Where studies and models are kept; nothing: nowhere.
std::optional<std::filesystem::path> sessionsOf(const CommandLine& line);

study::StudySource sourceOf(const CommandLine& line);

// As a person has the window. Needs the application, which knows the screen.
Result<MainWindowOptions> windowOptions(const CommandLine& line);

// Whoever ends the program from outside loses nothing of what was chosen and measured. All three live as long
// as the event loop.
void keepWorkWhenAskedToEnd(QApplication& application, MainWindow& window, QuitSignals& quitSignals);

}  // namespace macula::viewer
