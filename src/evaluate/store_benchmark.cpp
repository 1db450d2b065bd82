#include "evaluate/store_benchmark.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <random>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/draft.h"
#include "base/elapsed.h"
#include "base/sha256.h"
#include "evaluate/measurement.h"
#include "session/store.h"

namespace macula::evaluate {

namespace {

namespace fs = std::filesystem;
using session::Store;

constexpr const char* kMemory = "/dev/shm";

std::string volumeOf(int series) {
    return sha256Hex(fmt::format("volume {}", series));
}

session::OpenedVolume openedVolume(const StoreBenchmarkOptions& options, int series) {
    const std::string study = fmt::format("study {}", series / options.seriesPerStudy);
    return {.study = session::studyIdentity(study),
            .series = session::seriesIdentity(study, fmt::format("series {}", series)),
            .volume = volumeOf(series),
            .readableStudy = {},
            .readableSeries = {}};
}

// Spreads the volumes that have models over the whole store.
session::ModelKey keyOf(const StoreBenchmarkOptions& options, int model) {
    const std::int64_t volumes = std::int64_t(options.studies) * options.seriesPerStudy;
    const std::int64_t withModels = (options.models + 1) / 2;
    MACULA_CHECK(withModels <= volumes);
    return {.volume = volumeOf(static_cast<int>(model / 2 * volumes / withModels)),
            .trainer = 1,
            .parts = {{"transfer-function", sha256Hex(model % 2 == 0 ? "one" : "another")}}};
}

std::vector<std::byte> blobOf(std::size_t bytes, int model) {
    std::mt19937 random(static_cast<std::uint32_t>(model));
    std::vector<std::byte> blob(bytes);
    for (std::byte& byte : blob) byte = static_cast<std::byte>(random() & 0xffu);
    return blob;
}

Result<void> fill(const fs::path& folder, const StoreBenchmarkOptions& options, Progress& progress) {
    MACULA_TRY(Store store, Store::open({.folder = folder}));
    const int series = options.studies * options.seriesPerStudy;
    progress.beginStage(Text("Making a large store"),
                        static_cast<std::size_t>(series) + static_cast<std::size_t>(options.models));
    for (int i = 0; i < series; ++i) {
        if (progress.cancelled()) return cancelledError();
        MACULA_TRY_VOID(store.recordOpened(openedVolume(options, i)));
        progress.advance();
    }
    for (int i = 0; i < options.models; ++i) {
        if (progress.cancelled()) return cancelledError();
        MACULA_TRY([[maybe_unused]] const session::SaveReport saved,
                   store.saveModel(keyOf(options, i), blobOf(options.modelBytes, i)));
        progress.advance();
    }
    return {};
}

// Nothing if there is no room.
std::optional<Draft> folderInMemory(const StoreBenchmarkOptions& options) {
    constexpr std::uintmax_t kForRows = std::uintmax_t(1) << 28;
    const std::uintmax_t needed =
        kForRows + 2 * static_cast<std::uintmax_t>(options.models) * options.modelBytes;
    std::error_code error;
    if (!fs::is_directory(kMemory, error)) return {};
    const fs::space_info space = fs::space(kMemory, error);
    if (error || space.available < needed) return {};
    removeAbandonedDrafts(kMemory);
    Result<Draft> draft = Draft::beside(fs::path(kMemory) / "macula-bench-store", Draft::Kind::folder);
    if (!draft) return {};
    return std::optional<Draft>(std::move(*draft));
}

// Fills the store in memory if possible: tens of thousands of calls that wait for the disk take half an hour.
Result<void> make(const fs::path& folder, const StoreBenchmarkOptions& options, Progress& progress,
                  StoreBenchmark& measured) {
    const auto start = std::chrono::steady_clock::now();
    const std::optional<Draft> memory = folderInMemory(options);
    const fs::path made = memory ? memory->path() / "store" : folder;
    MACULA_TRY_VOID(fill(made, options, progress));
    if (memory) {
        std::error_code error;
        fs::copy(made, folder, fs::copy_options::recursive, error);
        if (error)
            return Error{ErrorCode::outputNotWritable, Text("The store that was made could not be copied."),
                         folder.string(), Text("Check free space and permissions.")};
        sync();  // otherwise the first measured call that syncs would wait for all of this
    }
    measured.makeSeconds = secondsSince(start);
    measured.wasMadeInMemory = memory.has_value();
    return {};
}

Result<void> measureListing(Store& store, int repetitions, StoreBenchmark& measured) {
    session::Listing<session::StudyEntry> listing;
    const auto list = [&]() -> Result<void> {
        MACULA_TRY(listing, store.listStudies());
        return {};
    };
    MACULA_TRY(measured.firstListingMs, timedMs(list));
    MACULA_TRY(measured.listingMs, medianMs(repetitions, list));
    measured.studies = listing.entries.size();
    for (const session::StudyEntry& study : listing.entries) {
        measured.series += study.series;
        measured.models += study.models;
        measured.modelBytes += study.modelBytes;
    }
    return {};
}

// Each turn uses another model.
Result<void> measureModels(Store& store, const StoreBenchmarkOptions& options, StoreBenchmark& measured) {
    int turn = 0;
    std::optional<session::ModelInfo> info;
    const auto find = [&]() -> Result<void> {
        const std::int64_t model = std::int64_t(turn++) * options.models / (options.repetitions + 1);
        MACULA_TRY(info, store.findModel(keyOf(options, static_cast<int>(model))));
        if (!info) return session::errorOf(session::Trouble::modelGone, store.folder());
        return {};
    };
    MACULA_TRY(measured.findMs, medianMs(options.repetitions, find));
    turn = 0;
    MACULA_TRY(measured.findAndReadMs, medianMs(options.repetitions, [&]() -> Result<void> {
                   MACULA_TRY_VOID(find());
                   MACULA_TRY([[maybe_unused]] const session::LoadedModel loaded, store.readModel(*info));
                   return {};
               }));
    return {};
}

Result<void> measureEviction(Store& store, StoreBenchmark& measured) {
    measured.capBytes = measured.modelBytes / 2;
    MACULA_TRY(measured.evictionMs, timedMs([&]() -> Result<void> {
                   MACULA_TRY(const session::EvictionReport evicted, store.evictModels(measured.capBytes));
                   measured.evictedModels = evicted.models;
                   return {};
               }));
    MACULA_TRY(const session::Listing<session::ModelInfo> left, store.listModels());
    for (const session::ModelInfo& info : left.entries) measured.bytesLeft += info.bytes;
    std::error_code error;
    for (fs::directory_iterator entry(store.folder() / "models", error), end; !error && entry != end;
         entry.increment(error)) {
        const std::uintmax_t bytes = entry->file_size(error);
        if (!error) measured.fileBytesLeft += bytes;
    }
    if (error) return session::errorOf(session::Trouble::diskError, store.folder());
    return {};
}

}  // namespace

Result<StoreBenchmark> measureStore(const fs::path& folder, const StoreBenchmarkOptions& options,
                                    Progress& progress) {
    StoreBenchmark measured;
    MACULA_TRY_VOID(make(folder, options, progress, measured));
    progress.beginStage(Text("Measuring a large store"), 3);
    std::optional<Store> store;
    MACULA_TRY(measured.openMs, timedMs([&]() -> Result<void> {
                   MACULA_TRY(Store opened, Store::open({.folder = folder}));
                   store.emplace(std::move(opened));
                   return {};
               }));
    MACULA_TRY_VOID(measureListing(*store, options.repetitions, measured));
    progress.advance();
    MACULA_TRY_VOID(measureModels(*store, options, measured));
    progress.advance();
    MACULA_TRY_VOID(measureEviction(*store, measured));
    progress.advance();
    return measured;
}

}  // namespace macula::evaluate
