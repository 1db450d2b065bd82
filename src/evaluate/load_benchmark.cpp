#include "evaluate/load_benchmark.h"

#include "base/plugin.h"

namespace macula::evaluate {

Result<LoadBenchmark> benchmarkLoading(const LoadBenchmarkOptions& options, Progress& progress) {
    MACULA_TRY(void* symbol, symbolOfPlugin("macula-load-benchmark", "maculaBenchmarkLoading"));
    Result<LoadBenchmark> result = LoadBenchmark{};
    reinterpret_cast<decltype(&maculaBenchmarkLoading)>(symbol)(options, progress, result);
    return result;
}

}  // namespace macula::evaluate
