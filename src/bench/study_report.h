// What the verbs that measure one study and print a report do besides.
#pragma once

#include <fmt/format.h>

#include "base/progress_bar.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/report.h"
#include "evaluate/benchmark_reports.h"

namespace macula::bench {

// `measure` of the study that is opened; its reportOf on stdout. `keep` gets what was measured
// after the report is printed, so that a file that cannot be written loses no numbers.
template <class Options, class Measure, class Keep>
Result<void> printReport(const evaluate::BenchStudyOptions& input, const Options& options, Measure measure,
                         Keep keep) {
    Progress progress(terminalProgressBar(), cli::interruptToken());
    MACULA_TRY(const evaluate::BenchStudy study, evaluate::openBenchStudy(input, progress));
    cli::printNotes(study.notes, study.warnings);
    MACULA_TRY(const auto report, measure(study, options, progress));
    fmt::print("{}\n", cli::jsonText(reportOf(study, options, report)));
    return keep(report);
}

template <class Options, class Measure>
Result<void> printReport(const evaluate::BenchStudyOptions& input, const Options& options, Measure measure) {
    return printReport(input, options, measure, [](const auto&) { return Result<void>(); });
}

// The same, of options with a check(input, options) that tells what is wrong before anything takes time.
template <class Options, class Measure>
Result<void> checkAndPrintReport(const evaluate::BenchStudyOptions& input, const Options& options,
                                 Measure measure) {
    MACULA_TRY_VOID(check(input, options));
    return printReport(input, options, measure);
}

}  // namespace macula::bench
