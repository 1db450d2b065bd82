// What the command says when something is wrong, and how it ends.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"

namespace macula::cli {

// 0 done, 2 usage (or a place that cannot be written to), 3 input not usable, 4 device not usable or out of
// memory, 130 interrupted.
int exitCode(ErrorCode code);

// One line: "The folder does not exist. Check the path. (/some/where)".
std::string describe(const Error& error);

// One line on stderr each, "macula: …". `note` is for what the user should know though all went well.
void printError(const Error& error);
void printNote(std::string_view sentence);
// Of what changes what is seen, or takes its ground away: look before you rely on it.
void printWarning(std::string_view sentence);

// What was made, where, and how long that took since `start`; on stderr, as stdout is for what was asked for.
void printWritten(const std::filesystem::path& path, std::chrono::steady_clock::time_point start);

}  // namespace macula::cli
