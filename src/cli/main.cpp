// The `macula` command: a list of verbs.
#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "base/core_dumps.h"
#include "base/exit_codes.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/report.h"
#include "live/device/open_device.h"
#include "scene/choice/nearest_name.h"

namespace {

// A file that is opened must not get the number of a stream that is closed: what is printed would be written
// into it. What stands in takes nothing, so that it is told where that matters.
void occupyStandardStreams() {
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
        if (fcntl(stream, F_GETFD) < 0) static_cast<void>(open("/dev/null", O_RDONLY));
    }
}

// A word that is empty is a variable of a script that was not set, and means no default.
macula::Result<void> refuseEmptyWords(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& word : option->results()) {
            if (word.empty())
                return macula::Error{macula::ErrorCode::usage,
                                     fmt::format("{} is empty.", option->get_name()),
                                     {},
                                     "Give a value, or leave it out."};
        }
    }
    for (const CLI::App* verb : app.get_subcommands()) MACULA_TRY_VOID(refuseEmptyWords(*verb));
    return {};
}

int tellThatStdoutFailed() {
    macula::cli::printError({macula::ErrorCode::outputNotWritable,
                             "Standard output could not be written to the end.",
                             {},
                             "Check free space where it goes."});
    return macula::exitCodeOf(macula::ErrorCode::outputNotWritable);
}

bool stdoutIsWhole() {
    return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

int run(int argc, char** argv) {
    using namespace macula;
    cli::interruptToken();  // from here on who stops it finds nothing half done
    CLI::App app{"Macula: path-traced anatomy from DICOM.", "macula"};
    app.set_version_flag("--version", "macula " MACULA_VERSION);
    app.require_subcommand(1);
    app.footer("Exit codes: " + std::string(kExitCodes) + ".");

    cli::Action action;
    cli::addInfo(app, action);
    cli::addRender(app, action);
    cli::addHybrid(app, action);
    cli::addSheet(app, action);
    cli::addSplatRender(app, action);
    cli::addSplatExport(app, action);
    cli::addExport(app, action);
    cli::addPresets(app, action);
    cli::addDevices(app, action);
    cli::addPhantom(app, action);
    cli::addBench(app, action);
    cli::addTrain(app, action);
    cli::addEvaluate(app, action);
    cli::addSessions(app, action);
    cli::addXr(app, action);

    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // --help, --version
        const int code = app.exit(asked);
        std::cout.flush();
        return stdoutIsWhole() ? code : tellThatStdoutFailed();
    } catch (const CLI::ParseError& error) {
        std::string message = error.what();
        if (!message.empty() && message.back() != '.') message += '.';
        const auto chosen = app.get_subcommands();
        if (chosen.empty() && argc > 1 && argv[1][0] != '-') {
            std::vector<std::string> verbs;
            for (const CLI::App* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
            const Error unknown{ErrorCode::usage,
                                fmt::format("There is no verb {}.", argv[1]),
                                {},
                                scene::choiceAmong(argv[1], verbs) + " See macula --help."};
            cli::printError(unknown);
            return exitCodeOf(unknown.code);
        }
        const std::string verb = chosen.empty() ? "" : chosen.front()->get_name() + " ";
        const Error usage{ErrorCode::usage, message, {}, "See macula " + verb + "--help."};
        cli::printError(usage);
        return exitCodeOf(usage.code);
    }

    if (const auto none = refuseEmptyWords(app); !none) {
        cli::printError(none.error());
        return exitCodeOf(none.error().code);
    }
    live::keepKernelsIn(live::usualKernelsFolder());
    if (const auto done = action(); !done) {
        cli::printError(done.error());
        return exitCodeOf(done.error().code);
    }
    return stdoutIsWhole() ? kExitDone : tellThatStdoutFailed();
}

}  // namespace

int main(int argc, char** argv) {
    macula::switchCoreDumpsOff();
    occupyStandardStreams();
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        std::fputs("macula: There is not enough memory. Close other programs, or open a smaller series.\n",
                   stderr);
        return macula::kExitDevice;
    } catch (const std::exception&) {
        if (!stdoutIsWhole()) return tellThatStdoutFailed();
        std::fputs("macula: Something went wrong that Macula did not foresee. Please report what you did.\n",
                   stderr);
        return macula::kExitFault;
    }
}
