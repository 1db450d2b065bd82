#include "pipeline/hybrid/model/peripheral_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "pipeline/splat/files/option_lines.h"
#include "pipeline/splat/files/splat_chunks.h"
#include "pipeline/splat/files/text_lines.h"
#include "pipeline/splat/files/view_chunks.h"

namespace macula::hybrid {

namespace {

using splat::Chunk;
using splat::ChunkFile;
using splat::SplatChunkNames;
using splat::SplatChunks;
using View = splat::TrainingState::View;

constexpr SplatChunkNames kShown{.text = "shown", .numbers = "shownspl"};
constexpr SplatChunkNames kBest{.text = "best", .numbers = "bestspl"};
constexpr splat::ViewChunkNames kHeldOut{.records = "heldout", .pixels = "heldpix"};
constexpr std::string_view kNotes = "notes";
constexpr std::string_view kFirst = "first ";  // prefix of each option of the first training

struct Notes {
    double gain = 1.0;
    Box seenMm;
    std::uint64_t generation = 0;
    std::uint64_t offered = 0;
    std::uint64_t asked = 0;
    std::uint64_t roundViews = 0;
    std::uint64_t heldOut = 0;  // pictures
    bool isShownApart = false;  // in chunks of its own; else the model of the training
    bool isBestApart = false;   // else the shown one
    std::vector<std::string> first;
};

std::string textOf(const Notes& notes) {
    const auto& [gain, seenMm, generation, offered, asked, roundViews, heldOut, isShownApart, isBestApart,
                 first] = notes;
    std::string box;
    for (const glm::dvec3& corner : {seenMm.low, seenMm.high})
        for (int axis = 0; axis < 3; ++axis) box += " " + splat::exactText(corner[axis]);
    std::vector<std::string> lines{"gain " + splat::exactText(gain),
                                   "seen-mm" + box,
                                   fmt::format("generation {}", generation),
                                   fmt::format("offered {}", offered),
                                   fmt::format("asked {}", asked),
                                   fmt::format("round-views {}", roundViews),
                                   fmt::format("held-out {}", heldOut),
                                   fmt::format("shown-apart {}", isShownApart ? 1 : 0),
                                   fmt::format("best-apart {}", isBestApart ? 1 : 0)};
    for (const std::string& option : first) lines.push_back(std::string(kFirst) + option);
    return splat::joinLines(lines);
}

Result<Notes> readNotes(ChunkFile& file) {
    MACULA_TRY(const std::string text, file.readText(kNotes));
    const std::vector<std::string> lines = splat::splitLines(text);
    Notes notes;
    MACULA_TRY(const std::vector<double> gain, splat::numbersIn(lines, "gain", 1));
    notes.gain = gain[0];
    MACULA_TRY(const std::vector<double> box, splat::numbersIn(lines, "seen-mm", 6));
    notes.seenMm = {.low = {box[0], box[1], box[2]}, .high = {box[3], box[4], box[5]}};
    if (!areUsable(notes.seenMm, notes.gain)) return splat::damagedModel();
    MACULA_TRY(notes.generation, splat::numberIn(lines, "generation", UINT64_MAX));
    MACULA_TRY(notes.offered, splat::numberIn(lines, "offered", UINT64_MAX));
    MACULA_TRY(notes.asked, splat::numberIn(lines, "asked", UINT64_MAX));
    MACULA_TRY(notes.roundViews, splat::numberIn(lines, "round-views", UINT64_MAX));
    MACULA_TRY(notes.heldOut, splat::numberIn(lines, "held-out", splat::kMostViews));
    MACULA_TRY(const std::uint64_t shownApart, splat::numberIn(lines, "shown-apart", 1));
    MACULA_TRY(const std::uint64_t bestApart, splat::numberIn(lines, "best-apart", 1));
    notes.isShownApart = shownApart == 1;
    notes.isBestApart = bestApart == 1;
    for (const std::string& line : lines)
        if (line.starts_with(kFirst)) notes.first.push_back(line.substr(kFirst.size()));
    return notes;
}

bool isTrainingOnly(const ChunkFile& file) {
    return std::none_of(kPeripheralChunks.begin(), kPeripheralChunks.end(),
                        [&](const splat::TrainingChunk& chunk) { return file.has(chunk.name); });
}

// Nothing if the splats are those of `other`, bit for bit.
std::optional<SplatChunks> apartFrom(const SplatChunks& other,
                                     const std::shared_ptr<const splat::Splats>& splats) {
    if (!splats) return std::nullopt;
    SplatChunks chunks(*splats);
    if (chunks.isSameAs(other)) return std::nullopt;
    return chunks;
}

void append(std::vector<Chunk>& chunks, const std::optional<SplatChunks>& splats,
            const SplatChunkNames& names) {
    if (!splats) return;
    for (Chunk& chunk : splats->named(names)) chunks.push_back(std::move(chunk));
}

Result<std::shared_ptr<const splat::Splats>> readApart(ChunkFile& file, const SplatChunkNames& names) {
    MACULA_TRY(splat::Splats splats, splat::readSplats(file, names));
    MACULA_TRY_VOID(splats.validate());
    return std::make_shared<const splat::Splats>(std::move(splats));
}

}  // namespace

Result<void> writePeripheral(std::ostream& stream, const PeripheralState& state,
                             splat::PackedPictures& packed) {
    MACULA_TRY_VOID(state.validate());
    // The bindings count the members: with a new one this does not compile until it is written.
    const auto& [training, heldOut, shown, best, generation, seenMm, gain, offered, asked, roundViews,
                 first] = state;
    std::vector<std::shared_ptr<const splat::TrainingView>> pictures;
    std::vector<View> judges;
    for (const View& view : training.views) pictures.push_back(view.given);
    for (const auto& picture : heldOut) {
        pictures.push_back(picture);
        judges.push_back({.given = picture});
    }
    MACULA_TRY_VOID(packed.pack(pictures));

    const SplatChunks trained(training.splats);
    const std::optional<SplatChunks> shownApart = apartFrom(trained, shown);
    const std::optional<SplatChunks> bestApart = apartFrom(shownApart ? *shownApart : trained, best);
    const std::string notes = textOf({.gain = gain,
                                      .seenMm = seenMm,
                                      .generation = generation,
                                      .offered = offered,
                                      .asked = asked,
                                      .roundViews = roundViews,
                                      .heldOut = heldOut.size(),
                                      .isShownApart = shownApart.has_value(),
                                      .isBestApart = bestApart.has_value(),
                                      .first = splat::linesOf(first)});
    std::vector<Chunk> early;
    append(early, shownApart, kShown);
    early.push_back({std::string(kNotes), std::as_bytes(std::span(notes)), 0});
    append(early, bestApart, kBest);
    const std::vector<std::byte> records = splat::viewRecords(judges);
    std::vector<Chunk> late;
    late.push_back({std::string(kHeldOut.records), records, splat::kViewRecordBytes});
    for (const auto& picture : heldOut)
        late.push_back({std::string(kHeldOut.pixels), std::as_bytes(std::span(picture->pixels)),
                        splat::kPixelBytes, packed.of(picture)});
    return splat::writeTraining(stream, training, {.early = early, .late = late}, packed);
}

Result<PeripheralFile> readPeripheral(std::istream& stream, std::uint64_t size) {
    MACULA_TRY(ChunkFile file, ChunkFile::open(stream, size, splat::kTrainingFileVersion));
    PeripheralFile read{.isTrainingOnly = isTrainingOnly(file)};
    PeripheralState& state = read.state;
    MACULA_TRY(state.training, splat::readTraining(file));
    if (read.isTrainingOnly) return read;
    MACULA_TRY(const Notes notes, readNotes(file));
    state.gain = notes.gain;
    state.seenMm = notes.seenMm;
    state.generation = notes.generation;
    state.offered = notes.offered;
    state.asked = notes.asked;
    state.roundViews = notes.roundViews;
    MACULA_TRY(state.first, splat::optionsOf(notes.first));
    if (state.first.capacity > 0) state.first.key = state.training.options.key;
    if (notes.isShownApart) {
        MACULA_TRY(state.shown, readApart(file, kShown));
    }
    if (notes.isBestApart) {
        MACULA_TRY(state.best, readApart(file, kBest));
    }
    MACULA_TRY(const std::vector<View> judges, splat::readViews(file, kHeldOut, notes.heldOut));
    std::transform(judges.begin(), judges.end(), std::back_inserter(state.heldOut),
                   [](const View& view) { return view.given; });
    MACULA_TRY_VOID(state.validate());
    return read;
}

Result<DrawableModel> readDrawable(std::istream& stream, std::uint64_t size) {
    MACULA_TRY(ChunkFile file, ChunkFile::openUntil(stream, size, splat::kTrainingFileVersion, kNotes));
    MACULA_TRY(splat::TrainingHead head, splat::readTrainingHead(file));
    DrawableModel model{.key = std::move(head.key),
                        .trainerVersion = head.trainerVersion,
                        .steps = head.steps,
                        .isTrainingOnly = isTrainingOnly(file)};
    SplatChunkNames shown = splat::kModelChunks;
    if (!model.isTrainingOnly) {
        MACULA_TRY(const Notes notes, readNotes(file));
        model.gain = notes.gain;
        model.seenMm = notes.seenMm;
        if (notes.isShownApart) shown = kShown;
    }
    MACULA_TRY(model.splats, readApart(file, shown));
    return model;
}

}  // namespace macula::hybrid
