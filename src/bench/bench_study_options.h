// Options of the verbs that measure something of one study.
#pragma once

#include "evaluate/bench_study.h"

namespace CLI {
class App;
}

namespace macula::bench {

// What the benchmarks of the tracer have in common; `size` is the default.
void addBenchStudyOptions(CLI::App& command, evaluate::BenchStudyOptions& options, int size);
// --camera, of those that look from one place.
void addBenchCamera(CLI::App& command, evaluate::BenchStudyOptions& options);

}  // namespace macula::bench
