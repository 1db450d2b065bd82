#include "pipeline/splat/files/training_file.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>
#include <map>
#include <type_traits>

#include "base/atomic_file.h"
#include "pipeline/splat/files/chunk_file.h"
#include "pipeline/splat/files/model_notes.h"
#include "pipeline/splat/files/option_lines.h"
#include "pipeline/splat/model/splat_components.h"

namespace macula::splat {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostSplats = std::uint64_t(1) << 28;
constexpr std::uint64_t kMostViews = std::uint64_t(1) << 20;
constexpr std::string_view kOption = "option ";

// A view in the file: RasterView, its weight, and what its loss was.
struct ViewRecord {
    double cameraFromWorld[9];  // by columns
    double eyeMm[3];
    double focalPx[2];
    double principalPx[2];
    double nearMm;
    double loss;
    double l1;
    std::int32_t sizePx[2];
    float weight;
    ViewKind kind;
};

constexpr std::uint32_t strideOf(std::string_view name) {
    const auto* found = std::ranges::find(kTrainingChunks, name, &TrainingChunk::name);
    return found->stride;  // not a chunk of the table: no constant expression
}
static_assert(strideOf("splats") == sizeof(float) && strideOf("steps") == sizeof(std::uint32_t));
static_assert(strideOf("stats") == sizeof(shared::SplatStatistics));
static_assert(strideOf("views") == sizeof(ViewRecord) && strideOf("pixels") == sizeof(glm::vec4));

// A chunk of the table, with its stride.
Chunk chunkOf(std::string_view name, std::span<const std::byte> bytes) {
    return {std::string(name), bytes, strideOf(name)};
}

ViewRecord recordOf(const TrainingState::View& view) {
    const RasterView& v = view.given->view;
    ViewRecord record{.nearMm = v.nearMm,
                      .loss = view.loss,
                      .l1 = view.l1,
                      .weight = view.given->weight,
                      .kind = view.given->kind};
    for (int i = 0; i < 9; ++i) record.cameraFromWorld[i] = v.cameraFromWorld[i / 3][i % 3];
    for (int i = 0; i < 3; ++i) record.eyeMm[i] = v.eyeMm[i];
    for (int i = 0; i < 2; ++i) {
        record.focalPx[i] = v.focalPx[i];
        record.principalPx[i] = v.principalPx[i];
        record.sizePx[i] = v.sizePx[i];
    }
    return record;
}

RasterView viewOf(const ViewRecord& record) {
    RasterView v{.nearMm = record.nearMm};
    for (int i = 0; i < 9; ++i) v.cameraFromWorld[i / 3][i % 3] = record.cameraFromWorld[i];
    for (int i = 0; i < 3; ++i) v.eyeMm[i] = record.eyeMm[i];
    for (int i = 0; i < 2; ++i) {
        v.focalPx[i] = record.focalPx[i];
        v.principalPx[i] = record.principalPx[i];
        v.sizePx[i] = record.sizePx[i];
    }
    return v;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

// The number behind "NAME " in the only line that begins so, at most `most`.
Result<std::uint64_t> numberIn(const std::vector<std::string>& lines, const std::string& name,
                               std::uint64_t most) {
    std::uint64_t value = 0;
    int found = 0;
    for (const std::string_view line : lines) {
        if (!line.starts_with(name + " ")) continue;
        const auto [end, error] =
            std::from_chars(line.data() + name.size() + 1, line.data() + line.size(), value);
        if (error != std::errc() || end != line.data() + line.size()) return damagedModel();
        ++found;
    }
    if (found != 1 || value > most) return damagedModel();
    return value;
}

template <class T>
std::span<const std::byte> bytesOf(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    return std::as_bytes(std::span(values));
}

template <class T>
Result<std::vector<T>> readArray(ChunkFile& file, std::string_view name, std::uint64_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    MACULA_TRY(const std::vector<std::byte> bytes, file.read(name, count * sizeof(T)));
    std::vector<T> values(count);
    if (count > 0) std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
}

// Reads the splats without validating them.
Result<Splats> readSplats(ChunkFile& file) {
    MACULA_TRY(const std::string text, file.readText("model"));
    const std::vector<std::string> lines = linesOf(text);
    Splats like;
    MACULA_TRY(const std::uint64_t count, numberIn(lines, "splats", kMostSplats));
    MACULA_TRY(const std::uint64_t degree, numberIn(lines, "degree", kMaxShDegree));
    like.shDegree = static_cast<int>(degree);
    MACULA_TRY_VOID(applyNotes(lines, like));
    const auto perSplat = static_cast<std::uint64_t>(componentCount(like.shDegree));
    MACULA_TRY(const std::vector<float> components, readArray<float>(file, "splats", count * perSplat));
    return splatsOf(components, like);
}

// Reads the views: the chunks of their pixels one by one, and then unpacks them together on all cores.
Result<std::vector<TrainingState::View>> readViews(ChunkFile& file, std::uint64_t count) {
    MACULA_TRY(const std::vector<ViewRecord> records, readArray<ViewRecord>(file, "views", count));
    std::vector<const ChunkEntry*> entries;
    for (const ChunkEntry& entry : file.entries()) {
        if (entry.name == "pixels") entries.push_back(&entry);
    }
    if (entries.size() != count) return damagedModel();
    std::vector<Result<std::vector<std::byte>>> bytes;
    std::vector<TrainingView> given(count);
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < count; ++i) {
        given[i] = {.view = viewOf(records[i]), .weight = records[i].weight, .kind = records[i].kind};
        if (!validate(given[i].view).ok() || records[i].kind > ViewKind::standIn) return damagedModel();
        const auto pixels = static_cast<std::uint64_t>(given[i].view.sizePx.x) *
                            static_cast<std::uint64_t>(given[i].view.sizePx.y);
        if (entries[i]->plainBytes != pixels * sizeof(glm::vec4)) return damagedModel();
        total += entries[i]->plainBytes;
        bytes.push_back(file.stored(*entries[i]));
        if (!bytes.back().ok()) return bytes.back().error();
    }
    forEachChunk(count, total, [&](std::size_t i) {
        bytes[i] = ChunkFile::unpacked(*entries[i], std::move(bytes[i]).value());
        if (!bytes[i].ok()) return;
        given[i].pixels.resize(bytes[i]->size() / sizeof(glm::vec4));
        std::memcpy(given[i].pixels.data(), bytes[i]->data(), bytes[i]->size());
        bytes[i] = std::vector<std::byte>{};
    });
    std::vector<TrainingState::View> views;
    for (std::size_t i = 0; i < count; ++i) {
        if (!bytes[i].ok()) return bytes[i].error();
        views.push_back({.given = std::make_shared<const TrainingView>(std::move(given[i])),
                         .loss = records[i].loss,
                         .l1 = records[i].l1});
    }
    return views;
}

Result<void> checkTrainer(std::uint64_t version) {
    TrainingState named{.trainerVersion = static_cast<std::uint32_t>(version)};
    return named.validate();
}

}  // namespace

Result<void> writeTraining(std::ostream& stream, const TrainingState& state) {
    MACULA_TRY_VOID(state.validate());
    // The bindings count the members: one more, and this does not compile until it is written.
    const auto& [trainerVersion, options, steps, splats, optimizer, statistics, views] = state;
    const auto& [stepsDone, stepsOfEach, first, second] = optimizer;
    std::vector<std::string> lines = notesOf(splats);
    lines.push_back(fmt::format("splats {}", splats.size()));
    lines.push_back(fmt::format("degree {}", splats.shDegree));
    const std::string model = joined(lines);
    lines = {fmt::format("trainer {}", trainerVersion), fmt::format("steps {}", steps),
             fmt::format("optimizer-steps {}", stepsDone), fmt::format("views {}", views.size())};
    for (const std::string& option : linesOf(options)) lines.push_back(std::string(kOption) + option);
    const std::string training = joined(lines);
    const std::vector<float> components = componentsOf(splats);
    std::vector<ViewRecord> records;
    for (const TrainingState::View& view : views) records.push_back(recordOf(view));

    std::vector<Chunk> chunks{
        chunkOf("model", std::as_bytes(std::span(model))),
        chunkOf("splats", bytesOf(components)),
        chunkOf("training", std::as_bytes(std::span(training))),
        chunkOf("key", std::as_bytes(std::span(options.key))),
        chunkOf("first", bytesOf(first)),
        chunkOf("second", bytesOf(second)),
        chunkOf("steps", bytesOf(stepsOfEach)),
        chunkOf("stats", bytesOf(statistics)),
        chunkOf("views", bytesOf(records)),
    };
    for (const TrainingState::View& view : views)
        chunks.push_back(chunkOf("pixels", bytesOf(view.given->pixels)));
    return writeChunks(stream, kTrainingFileVersion, chunks);
}

Result<void> writeTraining(const fs::path& path, const TrainingState& state) {
    return writeAtomically(path, [&](const fs::path& temporary) -> Result<void> {
        std::ofstream stream(temporary, std::ios::binary);
        return writeTraining(stream, state);
    });
}

Result<TrainingState> readTraining(std::istream& stream, std::uint64_t size) {
    MACULA_TRY(ChunkFile file, ChunkFile::open(stream, size, kTrainingFileVersion));
    MACULA_TRY(const std::string text, file.readText("training"));
    const std::vector<std::string> lines = linesOf(text);
    MACULA_TRY(const std::uint64_t trainer, numberIn(lines, "trainer", UINT32_MAX));
    MACULA_TRY_VOID(checkTrainer(trainer));
    TrainingState state;
    std::vector<std::string> options;
    for (const std::string& line : lines)
        if (line.starts_with(kOption)) options.push_back(line.substr(kOption.size()));
    MACULA_TRY(state.options, optionsOf(options));
    MACULA_TRY(state.options.key, file.readText("key"));
    MACULA_TRY(state.steps, numberIn(lines, "steps", UINT64_MAX));
    MACULA_TRY(state.optimizer.stepsDone, numberIn(lines, "optimizer-steps", UINT64_MAX));
    MACULA_TRY(const std::uint64_t views, numberIn(lines, "views", kMostViews));
    MACULA_TRY(state.splats, readSplats(file));
    const std::uint64_t count = state.splats.size();
    const std::uint64_t numbers = count * static_cast<std::uint64_t>(componentCount(state.splats.shDegree));
    MACULA_TRY(state.optimizer.first, readArray<float>(file, "first", numbers));
    MACULA_TRY(state.optimizer.second, readArray<float>(file, "second", numbers));
    MACULA_TRY(state.optimizer.steps, readArray<std::uint32_t>(file, "steps", count));
    MACULA_TRY(state.statistics, readArray<shared::SplatStatistics>(file, "stats", count));
    MACULA_TRY(state.views, readViews(file, views));
    MACULA_TRY_VOID(state.validate());
    return state;
}

Result<TrainingState> readTraining(const fs::path& path) {
    std::error_code error;
    if (!fs::is_regular_file(path, error))
        return Error{ErrorCode::inputNotUsable, "The model does not exist.", path.string(),
                     "Check the path."};
    const std::uint64_t size = fs::file_size(path, error);
    std::ifstream stream(path, std::ios::binary);
    if (error || !stream)
        return Error{ErrorCode::inputNotUsable, "The model cannot be read.", path.string(),
                     "Check the path and its permissions."};
    std::string begin(kChunkFileMagic.size(), '\0');
    stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    if (!looksLikeTraining(begin))
        return Error{ErrorCode::inputNotUsable, "The file holds no training that could go on.", path.string(),
                     "Choose a .macula file, or train anew: PLY and SPZ hold only the model."};
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
    MACULA_TRY(Splats splats, readSplats(file));
    return finishModel(std::move(splats), bad);
}

}  // namespace macula::splat
