#include "cli/shared/program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/core_dumps.h"
#include "base/exit_codes.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/report.h"
#include "live/device/open_device.h"
#include "scene/choice/nearest_name.h"

namespace macula::cli {

namespace {

// A file that is opened must not get the number of a stream that is closed: what is printed would be written
// into it. A write to the stand-in fails, and whoever needs the write reports that.
void occupyStandardStreams() {
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
        if (fcntl(stream, F_GETFD) < 0) static_cast<void>(open("/dev/null", O_RDONLY));
    }
}

// A word that is empty is a variable of a script that was not set, and means no default.
Result<void> refuseEmptyWords(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& word : option->results()) {
            if (word.empty())
                return Error{ErrorCode::usage,
                             Text("{} is empty.", option->get_name()),
                             {},
                             Text("Give a value, or leave it out.")};
        }
    }
    for (const CLI::App* verb : app.get_subcommands()) MACULA_TRY_VOID(refuseEmptyWords(*verb));
    return {};
}

int tellThatStdoutFailed() {
    printError({ErrorCode::outputNotWritable,
                Text("Standard output could not be written to the end."),
                {},
                Text("Check free space where it goes.")});
    return exitCodeOf(ErrorCode::outputNotWritable);
}

bool stdoutIsWhole() {
    return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

Error unknownVerb(std::string_view given, Text hint) {
    return {ErrorCode::usage, Text("There is no verb {}.", given), {}, std::move(hint)};
}

// Tells what the parser of the command line did not understand.
Error usageError(const Program& program, const CLI::App& app, const CLI::ParseError& error, int argc,
                 char** argv) {
    const auto chosen = app.get_subcommands();
    if (chosen.empty() && argc > 1 && argv[1][0] != '-') {
        std::vector<std::string> verbs;
        for (const CLI::App* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
        return unknownVerb(argv[1],
                           Text("{} See {} --help.", scene::choiceAmong(argv[1], verbs), program.name));
    }
    std::string message = error.what();
    if (!message.empty() && message.back() != '.') message += '.';
    const std::string verb = chosen.empty() ? "" : chosen.front()->get_name() + " ";
    return {ErrorCode::usage, Text::verbatim(message), {}, Text("See {} {}--help.", program.name, verb)};
}

// Before anything is parsed: what follows a moved verb may be a verb here.
Result<void> refuseMovedVerb(const Program& program, int argc, char** argv) {
    const std::string_view given = argc > 1 ? argv[1] : "";
    for (const MovedVerb& moved : program.movedVerbs)
        if (given == moved.name) return unknownVerb(given, Text(moved.hint));
    return {};
}

int run(const Program& program, int argc, char** argv) {
    interruptToken();  // from here on who stops it finds nothing half done
    if (const auto known = refuseMovedVerb(program, argc, argv); !known) {
        printError(known.error());
        return exitCodeOf(known.error().code);
    }
    CLI::App app{fmt::format("Macula: {}", program.about), program.name};
    app.set_version_flag("--version", fmt::format("{} {}", program.name, MACULA_VERSION));
    app.require_subcommand(1);
    const std::string codes = fmt::format("Exit codes: {}.", kExitCodes);
    app.footer(codes);  // of each verb too, which is added to it
    Action action;
    program.addVerbs(app, action);
    if (program.footer != nullptr) app.footer(fmt::format("{}\n{}", program.footer, codes));

    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // --help, --version
        const int code = app.exit(asked);
        std::cout.flush();
        return stdoutIsWhole() ? code : tellThatStdoutFailed();
    } catch (const CLI::ParseError& error) {
        const Error usage = usageError(program, app, error, argc, argv);
        printError(usage);
        return exitCodeOf(usage.code);
    }

    if (const auto none = refuseEmptyWords(app); !none) {
        printError(none.error());
        return exitCodeOf(none.error().code);
    }
    live::keepKernelsIn(live::usualKernelsFolder());
    if (const auto done = action(); !done) {
        printError(done.error());
        return exitCodeOf(done.error().code);
    }
    return stdoutIsWhole() ? kExitDone : tellThatStdoutFailed();
}

}  // namespace

int runProgram(const Program& program, int argc, char** argv) {
    switchCoreDumpsOff();
    occupyStandardStreams();
    nameProgram(program.name);
    try {
        return run(program, argc, argv);
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr,
                     "%s: There is not enough memory. Close other programs, or open a smaller series.\n",
                     program.name);
        return kExitDevice;
    } catch (const std::exception&) {
        if (!stdoutIsWhole()) return tellThatStdoutFailed();
        std::fprintf(stderr,
                     "%s: Something went wrong that Macula did not foresee. Please report what you did.\n",
                     program.name);
        return kExitFault;
    }
}

}  // namespace macula::cli
