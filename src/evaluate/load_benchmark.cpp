#include "evaluate/load_benchmark.h"

#include "base/plugin.h"

namespace macula::evaluate {

std::vector<std::filesystem::path> filesOf(const dicom::Stack& stack) {
    std::vector<std::filesystem::path> files;
    if (!stack.isEven()) return files;
    for (const dicom::Frame& frame : stack.frames) {
        if (frame.instance->frames != 1) return {};
        files.push_back(frame.instance->file);
    }
    return files;
}

Result<LoadBenchmark> benchmarkLoading(const LoadBenchmarkOptions& options, Progress& progress) {
    MACULA_TRY(void* symbol, symbolOfPlugin("macula-load-benchmark", "maculaBenchmarkLoading"));
    Result<LoadBenchmark> result = LoadBenchmark{};
    reinterpret_cast<decltype(&maculaBenchmarkLoading)>(symbol)(options, progress, result);
    return result;
}

}  // namespace macula::evaluate
