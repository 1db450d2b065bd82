#include "pipeline/splat/files/splat_chunks.h"

#include <fmt/format.h>

#include <cstring>
#include <span>

#include "pipeline/splat/files/model_notes.h"
#include "pipeline/splat/files/text_lines.h"
#include "pipeline/splat/model/splat_components.h"

namespace macula::splat {

namespace {

constexpr std::uint64_t kMostSplats = std::uint64_t(1) << 28;

}  // namespace

SplatChunks::SplatChunks(const Splats& splats) : numbers_(componentsOf(splats)) {
    std::vector<std::string> lines = notesOf(splats);
    lines.push_back(fmt::format("splats {}", splats.size()));
    lines.push_back(fmt::format("degree {}", splats.shDegree));
    text_ = joinLines(lines);
}

std::array<Chunk, 2> SplatChunks::named(const SplatChunkNames& names) const {
    return {Chunk{std::string(names.text), std::as_bytes(std::span(text_)), 0},
            Chunk{std::string(names.numbers), std::as_bytes(std::span(numbers_)), sizeof(float)}};
}

bool SplatChunks::isSameAs(const SplatChunks& other) const {
    if (text_ != other.text_ || numbers_.size() != other.numbers_.size()) return false;
    return numbers_.empty() ||
           std::memcmp(numbers_.data(), other.numbers_.data(), numbers_.size() * sizeof(float)) == 0;
}

Result<Splats> readSplats(ChunkFile& file, const SplatChunkNames& names) {
    MACULA_TRY(const std::string text, file.readText(names.text));
    const std::vector<std::string> lines = splitLines(text);
    Splats like;
    MACULA_TRY(const std::uint64_t count, numberIn(lines, "splats", kMostSplats));
    MACULA_TRY(const std::uint64_t degree, numberIn(lines, "degree", kMaxShDegree));
    like.shDegree = static_cast<int>(degree);
    MACULA_TRY_VOID(applyNotes(lines, like));
    const auto perSplat = static_cast<std::uint64_t>(componentCount(like.shDegree));
    MACULA_TRY(const std::vector<float> numbers, file.readArray<float>(names.numbers, count * perSplat));
    return splatsOf(numbers, like);
}

}  // namespace macula::splat
