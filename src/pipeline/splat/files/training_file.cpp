#include "pipeline/splat/files/training_file.h"

#include <algorithm>
#include <fstream>
#include <memory>
#include <type_traits>
#include <vector>

#include "base/atomic_file.h"
#include "pipeline/splat/files/option_lines.h"
#include "pipeline/splat/files/text_lines.h"
#include "pipeline/splat/files/view_chunks.h"
#include "pipeline/splat/model/splat_components.h"

namespace macula::splat {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kOption = "option ";

constexpr std::uint32_t strideOf(std::string_view name) {
    const auto* found = std::ranges::find(kTrainingChunks, name, &TrainingChunk::name);
    return found->stride;  // for a name that is not in the table, this is not a constant expression
}
static_assert(strideOf("splats") == sizeof(float) && strideOf("steps") == sizeof(std::uint32_t));
static_assert(strideOf("stats") == sizeof(shared::SplatStatistics));
static_assert(strideOf("views") == kViewRecordBytes && strideOf("pixels") == kPixelBytes);

// A chunk with the stride of kTrainingChunks.
Chunk chunkOf(std::string_view name, std::span<const std::byte> bytes) {
    return {std::string(name), bytes, strideOf(name)};
}

template <class T>
std::span<const std::byte> bytesOf(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    return std::as_bytes(std::span(values));
}

Result<void> checkTrainer(std::uint64_t version) {
    TrainingState named{.trainerVersion = static_cast<std::uint32_t>(version)};
    return named.validate();
}

}  // namespace

Result<void> writeTraining(std::ostream& stream, const TrainingState& state, const FurtherChunks& further,
                           const PackedPictures& packed) {
    MACULA_TRY_VOID(state.validate());
    // The structured bindings list all members, so that a new member does not compile until it is written.
    const auto& [trainerVersion, options, steps, splats, optimizer, statistics, views] = state;
    const auto& [stepsDone, stepsOfEach, first, second] = optimizer;
    std::vector<std::string> lines{fmt::format("trainer {}", trainerVersion), fmt::format("steps {}", steps),
                                   fmt::format("optimizer-steps {}", stepsDone),
                                   fmt::format("views {}", views.size())};
    for (const std::string& option : linesOf(options)) lines.push_back(std::string(kOption) + option);
    const std::string training = joinLines(lines);
    const SplatChunks model(splats);
    const std::vector<std::byte> records = viewRecords(views);

    std::vector<Chunk> chunks;
    for (Chunk& chunk : model.named(kModelChunks)) chunks.push_back(std::move(chunk));
    chunks.push_back(chunkOf("training", std::as_bytes(std::span(training))));
    chunks.push_back(chunkOf("key", std::as_bytes(std::span(options.key))));
    chunks.insert(chunks.end(), further.early.begin(), further.early.end());
    chunks.push_back(chunkOf("first", bytesOf(first)));
    chunks.push_back(chunkOf("second", bytesOf(second)));
    chunks.push_back(chunkOf("steps", bytesOf(stepsOfEach)));
    chunks.push_back(chunkOf("stats", bytesOf(statistics)));
    chunks.push_back(chunkOf("views", records));
    for (const TrainingState::View& view : views) {
        chunks.push_back(chunkOf("pixels", bytesOf(view.given->pixels)));
        chunks.back().packed = packed.of(view.given);
    }
    chunks.insert(chunks.end(), further.late.begin(), further.late.end());
    return writeChunks(stream, kTrainingFileVersion, chunks);
}

Result<void> writeTraining(std::ostream& stream, const TrainingState& state) {
    MACULA_TRY_VOID(state.validate());
    std::vector<std::shared_ptr<const TrainingView>> pictures;
    for (const TrainingState::View& view : state.views) pictures.push_back(view.given);
    PackedPictures packed;
    MACULA_TRY_VOID(packed.pack(pictures));
    return writeTraining(stream, state, {}, packed);
}

Result<void> writeTraining(const fs::path& path, const TrainingState& state) {
    return writeAtomically(path, [&](const fs::path& temporary) -> Result<void> {
        std::ofstream stream(temporary, std::ios::binary);
        return writeTraining(stream, state);
    });
}

Result<TrainingHead> readTrainingHead(ChunkFile& file) {
    MACULA_TRY(const std::string text, file.readText("training"));
    const std::vector<std::string> lines = splitLines(text);
    TrainingHead head;
    MACULA_TRY(const std::uint64_t trainer, numberIn(lines, "trainer", UINT32_MAX));
    head.trainerVersion = static_cast<std::uint32_t>(trainer);
    MACULA_TRY(head.steps, numberIn(lines, "steps", UINT64_MAX));
    MACULA_TRY(head.key, file.readText("key"));
    return head;
}

Result<TrainingState> readTraining(ChunkFile& file) {
    MACULA_TRY(TrainingHead head, readTrainingHead(file));
    MACULA_TRY_VOID(checkTrainer(head.trainerVersion));
    MACULA_TRY(const std::string text, file.readText("training"));
    const std::vector<std::string> lines = splitLines(text);
    TrainingState state{.steps = head.steps};
    std::vector<std::string> options;
    for (const std::string& line : lines)
        if (line.starts_with(kOption)) options.push_back(line.substr(kOption.size()));
    MACULA_TRY(state.options, optionsOf(options));
    state.options.key = std::move(head.key);
    MACULA_TRY(state.optimizer.stepsDone, numberIn(lines, "optimizer-steps", UINT64_MAX));
    MACULA_TRY(const std::uint64_t views, numberIn(lines, "views", kMostViews));
    MACULA_TRY(state.splats, readSplats(file, kModelChunks));
    const std::uint64_t count = state.splats.size();
    const std::uint64_t numbers = count * static_cast<std::uint64_t>(componentCount(state.splats.shDegree));
    MACULA_TRY(state.optimizer.first, file.readArray<float>("first", numbers));
    MACULA_TRY(state.optimizer.second, file.readArray<float>("second", numbers));
    MACULA_TRY(state.optimizer.steps, file.readArray<std::uint32_t>("steps", count));
    MACULA_TRY(state.statistics, file.readArray<shared::SplatStatistics>("stats", count));
    MACULA_TRY(state.views, readViews(file, {.records = "views", .pixels = "pixels"}, views));
    MACULA_TRY_VOID(state.validate());
    return state;
}

Result<TrainingState> readTraining(std::istream& stream, std::uint64_t size) {
    MACULA_TRY(ChunkFile file, ChunkFile::open(stream, size, kTrainingFileVersion));
    return readTraining(file);
}

Result<TrainingState> readTraining(const fs::path& path) {
    std::error_code error;
    if (!fs::is_regular_file(path, error))
        return Error{ErrorCode::inputNotUsable, Text("The model does not exist."), path.string(),
                     Text("Check the path.")};
    const std::uint64_t size = fs::file_size(path, error);
    std::ifstream stream(path, std::ios::binary);
    if (error || !stream)
        return Error{ErrorCode::inputNotUsable, Text("The model cannot be read."), path.string(),
                     Text("Check the path and its permissions.")};
    std::string begin(kChunkFileMagic.size(), '\0');
    stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    if (!looksLikeTraining(begin))
        return Error{ErrorCode::inputNotUsable, Text("The file holds no training that could go on."),
                     path.string(),
                     Text("Choose a .macula file, or train anew: PLY and SPZ hold only the model.")};
    Result<TrainingState> state = readTraining(stream, size);
    if (state.ok()) return state;
    Error named = state.error();
    named.where = path.string();
    return named;
}

bool looksLikeTraining(std::string_view begin) {
    return begin.starts_with(kChunkFileMagic);
}

Result<ModelFile> readTrainedModel(std::istream& stream, std::uint64_t size, BadSplats bad) {
    MACULA_TRY(ChunkFile file, ChunkFile::open(stream, size, kTrainingFileVersion));
    MACULA_TRY(Splats splats, readSplats(file, kModelChunks));
    return finishModel(std::move(splats), bad);
}

}  // namespace macula::splat
