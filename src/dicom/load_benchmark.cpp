#include "dicom/load_benchmark.h"

#include "base/module.h"

namespace macula::dicom {

Result<LoadBenchmark> benchmarkLoading(const LoadBenchmarkOptions& options, Progress& progress) {
    MACULA_TRY(void* symbol, symbolOfModule("macula-load-benchmark", "maculaBenchmarkLoading"));
    Result<LoadBenchmark> result = LoadBenchmark{};
    reinterpret_cast<decltype(&maculaBenchmarkLoading)>(symbol)(options, progress, result);
    return result;
}

}  // namespace macula::dicom
