// .macula files taken apart, so that tests can change what is in them.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <functional>
#include <map>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/paths.h"
#include "pipeline/splat/files/chunk_file.h"
#include "pipeline/splat/files/training_file.h"

namespace macula::splat::testing {

// A file, to be put together again with one chunk changed and whole checksums.
class TakenApart {
  public:
    explicit TakenApart(const std::string& bytes) {
        std::istringstream stream(bytes);
        ChunkFile file = std::move(ChunkFile::open(stream, bytes.size(), kTrainingFileVersion)).value();
        entries_ = file.entries();
        for (const ChunkEntry& entry : entries_) {
            stored_.push_back(*file.stored(entry));
            const auto plain = *ChunkFile::unpacked(entry, stored_.back());
            plain_.emplace_back(reinterpret_cast<const char*>(plain.data()), plain.size());
        }
    }

    const std::vector<ChunkEntry>& entries() const { return entries_; }

    // Of several of that name all are changed.
    std::string with(std::string_view name, const std::function<void(std::string&)>& change) const {
        std::vector<std::string> changed(entries_.size());
        std::vector<Chunk> chunks;
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            chunks.push_back(chunk(i));
            if (entries_[i].name != name) continue;
            changed[i] = plain_[i];
            change(changed[i]);
            const bool isWhole = entries_[i].stride == 0 || changed[i].size() % entries_[i].stride == 0;
            chunks.back() = {entries_[i].name, std::as_bytes(std::span(changed[i])),
                             isWhole ? entries_[i].stride : 1};
        }
        return together(chunks);
    }

    std::string without(std::string_view name) const {
        std::vector<Chunk> chunks;
        for (std::size_t i = 0; i < entries_.size(); ++i)
            if (entries_[i].name != name) chunks.push_back(chunk(i));
        return together(chunks);
    }

  private:
    // As it was, without being packed again.
    Chunk chunk(std::size_t i) const {
        Chunk chunk{entries_[i].name, std::as_bytes(std::span(plain_[i])), entries_[i].stride};
        if (chunk.stride > 0) chunk.packed = stored_[i];
        return chunk;
    }
    static std::string together(const std::vector<Chunk>& chunks) {
        std::ostringstream out;
        EXPECT_TRUE(writeChunks(out, kTrainingFileVersion, chunks).ok());
        return out.str();
    }

    std::vector<ChunkEntry> entries_;
    std::vector<std::vector<std::byte>> stored_;
    std::vector<std::string> plain_;
};

inline void replace(std::string& text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
}

// Names of chunks to their strides, in the table of docs/model-files.md that begins so.
inline std::map<std::string, std::string> chunksOnThePage(std::string_view head) {
    std::map<std::string, std::string> strides;
    std::ifstream page(macula::test::projectFolder() / "docs/model-files.md");
    bool isTable = false;
    for (std::string line; std::getline(page, line);) {
        isTable = line.starts_with(head) || (isTable && line.starts_with("|"));
        const std::size_t names = isTable ? line.find('`') : std::string::npos;
        if (names == std::string::npos) continue;
        const std::size_t end = line.find('|', 1);
        const std::size_t next = line.find('|', end + 1);
        const std::string stride = line.substr(end + 2, next - end - 3);
        for (std::size_t at = names; at < end; at = line.find('`', at)) {
            const std::size_t close = line.find('`', at + 1);
            strides[line.substr(at + 1, close - at - 1)] = stride;
            at = close + 1;
        }
    }
    return strides;
}

}  // namespace macula::splat::testing
