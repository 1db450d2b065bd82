#include "evaluate/load_benchmark.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <thread>
#include <vector>

#include "base/elapsed.h"
#include "base/plugin.h"
#include "dicom/read/dataset.h"
#include "dicom/read/folder.h"
#include "dicom/scan.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::evaluate {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

double perSecond(std::size_t files, Clock::time_point since) {
    return static_cast<double>(files) / secondsSince(since);
}

double readAll(const std::vector<fs::path>& files, std::size_t threads,
               const std::function<void(const fs::path&)>& read) {
    std::atomic<std::size_t> next{0};
    const auto since = Clock::now();
    {
        std::vector<std::jthread> workers;
        for (std::size_t t = 0; t < threads; ++t) {
            workers.emplace_back([&] {
                for (std::size_t i = next++; i < files.size(); i = next++) read(files[i]);
            });
        }
    }
    return perSecond(files.size(), since);
}

void readWithDcmtk(const fs::path& file) {
    DcmFileFormat format;
    constexpr Uint32 kLongestValueRead = 4096;
    format.loadFileUntilTag(file.c_str(), EXS_Unknown, EGL_noChange, kLongestValueRead, ERM_autoDetect,
                            DCM_PixelData);
}

}  // namespace

Result<HeaderBenchmark> benchmarkHeaders(const fs::path& path, std::size_t threads, int rounds,
                                         Progress& progress) try {
    silenceToolkit();
    MACULA_TRY(const dicom::FolderListing listing, dicom::listFiles(path, progress));
    std::vector<fs::path> files;
    for (const fs::path& file : listing.files) {  // warms the cache too
        if (dicom::readHeader(file).header) files.push_back(file);
        if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Reading was cancelled."), {}, {}};
    }
    HeaderBenchmark result{
        .files = files.size(), .threads = std::max<std::size_t>(threads, 1), .rounds = rounds};
    progress.beginStage(Text("Reading headers"), static_cast<std::size_t>(std::max(rounds, 0)));
    for (int round = 0; round < rounds; ++round, progress.advance()) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Reading was cancelled."), {}, {}};
        result.headersPerSecond =
            std::max(result.headersPerSecond,
                     readAll(files, result.threads, [](const fs::path& f) { dicom::readHeader(f); }));
        result.bareDcmtkPerSecond =
            std::max(result.bareDcmtkPerSecond, readAll(files, result.threads, readWithDcmtk));
        Progress quiet({}, progress.token());
        const auto since = Clock::now();
        MACULA_TRY(const dicom::Scan scan, dicom::scanFolder(path, quiet));
        result.scanPerSecond = std::max(result.scanPerSecond, perSecond(scan.filesSeen, since));
    }
    return result;
} catch (const std::exception&) {
    return Error{ErrorCode::outOfMemory, Text("There is not enough memory to measure."), path.string(),
                 Text("Choose a smaller folder.")};
}

std::vector<fs::path> filesOf(const dicom::Stack& stack) {
    std::vector<fs::path> files;
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
