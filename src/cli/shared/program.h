// A program of verbs, from its arguments to its exit code.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <span>

#include "base/result.h"

namespace macula::cli {

// The work of a verb, which begins when the whole command line is understood.
using Action = std::function<Result<void>()>;

// A verb that another program has, and what the user does instead.
struct MovedVerb {
    const char* name;
    const char* hint;
};

struct Program {
    const char* name;   // as it is called, and as it begins its errors
    const char* about;  // a sentence
    // Each verb leaves its work in `action` when the user chose it.
    void (*addVerbs)(CLI::App& app, Action& action);
    std::span<const MovedVerb> movedVerbs = {};
    const char* footer = nullptr;  // of the help, above the exit codes
};

int runProgram(const Program& program, int argc, char** argv);

}  // namespace macula::cli
