// The `macula-bench` command: it measures how fast Macula is, and how good its pictures and models are.
#include "bench/command.h"
#include "cli/shared/program.h"

namespace {

void addVerbs(CLI::App& app, macula::cli::Action& action) {
    using namespace macula;
    bench::addTrace(app, action);
    bench::addCast(app, action);
    bench::addFoveal(app, action);
    bench::addTraceTradeoff(app, action);
    bench::addLoad(app, action);
    bench::addTrain(app, action);
    bench::addSession(app, action);
    bench::addXr(app, action);
    bench::addEvaluate(app, action);
}

}  // namespace

int main(int argc, char** argv) {
    return macula::cli::runProgram({.name = "macula-bench",
                                    .about = "how fast it is, and how good its pictures and models are.",
                                    .addVerbs = addVerbs},
                                   argc, argv);
}
