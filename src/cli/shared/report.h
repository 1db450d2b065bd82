// What a program says when something is wrong.
#pragma once

#include <chrono>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "base/text.h"

namespace macula::cli {

// Each line on stderr begins with `name`; with "macula" until a program calls this.
void nameProgram(const char* name);

// One line: "The folder does not exist. Check the path. (/some/where)".
std::string describe(const Error& error);

// One line on stderr each, "macula: …", or as the program is named. `note` is for what the user should know
// though all went well.
void printError(const Error& error);

// Objects, which can be given to whoever tells sentences, be they texts or not.
struct PrintsNote {
    void operator()(std::string_view sentence) const;
    void operator()(const Text& sentence) const;
};
inline constexpr PrintsNote printNote{};
// Of what changes what is seen, or takes its ground away: look before you rely on it.
struct PrintsWarning {
    void operator()(std::string_view sentence) const;
    void operator()(const Text& sentence) const;
};
inline constexpr PrintsWarning printWarning{};
// Each as a warning if it is among `warnings`, else as a note.
void printNotes(std::span<const Text> notes, std::span<const Text> warnings = {});

// What was made, where, and how long that took since `start`; on stderr, as stdout is for what was asked for.
// `what` is in it, of a folder: "300 pictures".
void printWritten(const std::filesystem::path& path, std::chrono::steady_clock::time_point start,
                  std::string_view what = {});

}  // namespace macula::cli
