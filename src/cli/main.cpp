// The `macula` command: a list of verbs.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "cli/command.h"
#include "cli/report.h"

namespace {

int run(int argc, char** argv) {
    using namespace macula;
    CLI::App app{"Macula: path-traced anatomy from DICOM.", "macula"};
    app.set_version_flag("--version", "macula " MACULA_VERSION);
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 done, 2 usage or output not writable, 3 input not usable, 4 device not usable or out "
        "of memory, 130 stopped.");

    cli::Action action;
    cli::addInfo(app, action);
    cli::addRender(app, action);
    cli::addSheet(app, action);
    cli::addSplatRender(app, action);
    cli::addExport(app, action);
    cli::addPresets(app, action);
    cli::addDevices(app, action);
    cli::addPhantom(app, action);
    cli::addBench(app, action);
    cli::addTrain(app, action);
    cli::addEvaluate(app, action);

    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // --help, --version
        return app.exit(asked);
    } catch (const CLI::ParseError& error) {
        std::string message = error.what();
        if (!message.empty() && message.back() != '.') message += '.';
        const auto chosen = app.get_subcommands();
        const std::string verb = chosen.empty() ? "" : chosen.front()->get_name() + " ";
        const Error usage{ErrorCode::usage, message, {}, "See macula " + verb + "--help."};
        cli::printError(usage);
        return cli::exitCode(usage.code);
    }

    if (const auto done = action(); !done) {
        cli::printError(done.error());
        return cli::exitCode(done.error().code);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        std::fputs("macula: There is not enough memory. Close other programs, or open a smaller series.\n",
                   stderr);
        return 4;
    } catch (const std::exception&) {
        std::fputs("macula: Something went wrong that Macula did not foresee. Please report what you did.\n",
                   stderr);
        return 1;
    }
}
