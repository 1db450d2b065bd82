#include "pipeline/splat/files/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>

#include "base/check.h"
#include "pipeline/splat/files/deflated.h"

namespace macula::splat {

namespace {

constexpr int kGzipOnly = MAX_WBITS + 16;
constexpr int kUnknownSystem = 255;
constexpr std::size_t kMostComment = 4096;

}  // namespace

Result<std::vector<std::byte>> gzip(std::span<const std::byte> data, const std::string& comment) {
    constexpr int kMemoryLevel = 8;
    std::string text = comment;
    gz_header header{};
    header.os = kUnknownSystem;
    if (!text.empty()) header.comment = reinterpret_cast<Bytef*>(text.data());
    return deflated(data, {Z_BEST_COMPRESSION, kGzipOnly, kMemoryLevel, Z_DEFAULT_STRATEGY}, &header);
}

struct Gunzip::State {
    z_stream stream{};
    gz_header header{};
    std::array<Bytef, kMostComment> comment{};
    bool usable = false;
    bool ended = false;
};

Gunzip::Gunzip(std::span<const std::byte> packed) : state_(std::make_unique<State>()) {
    MACULA_CHECK_LE(packed.size(), std::numeric_limits<uInt>::max());
    State& s = *state_;
    s.stream.next_in = zlibBytes(packed);
    s.stream.avail_in = static_cast<uInt>(packed.size());
    s.header.comment = s.comment.data();
    s.header.comm_max = static_cast<uInt>(s.comment.size());
    s.usable = inflateInit2(&s.stream, kGzipOnly) == Z_OK;
    if (s.usable) inflateGetHeader(&s.stream, &s.header);
}

Gunzip::~Gunzip() {
    if (state_->usable) inflateEnd(&state_->stream);
}

bool Gunzip::read(std::span<std::byte> out) {
    State& s = *state_;
    if (!s.usable || s.ended) return out.empty();
    MACULA_CHECK_LE(out.size(), std::numeric_limits<uInt>::max());
    s.stream.next_out = reinterpret_cast<Bytef*>(out.data());
    s.stream.avail_out = static_cast<uInt>(out.size());
    while (s.stream.avail_out > 0) {
        const int status = inflate(&s.stream, Z_NO_FLUSH);
        s.ended = status == Z_STREAM_END;
        if (status != Z_OK) break;
    }
    return s.stream.avail_out == 0;
}

std::optional<std::vector<std::byte>> Gunzip::rest(std::size_t most) {
    State& s = *state_;
    std::vector<std::byte> rest;
    std::array<Bytef, 4096> piece{};
    while (s.usable && !s.ended && rest.size() <= most) {
        s.stream.next_out = piece.data();
        s.stream.avail_out = static_cast<uInt>(piece.size());
        const int status = inflate(&s.stream, Z_NO_FLUSH);
        s.ended = status == Z_STREAM_END;
        const auto unpacked = std::as_bytes(std::span(piece)).first(piece.size() - s.stream.avail_out);
        rest.insert(rest.end(), unpacked.begin(), unpacked.end());
        if (status != Z_OK) break;
    }
    if (!s.ended || rest.size() > most) return {};
    return rest;
}

std::string Gunzip::headerComment() const {
    const State& s = *state_;
    if (s.header.comment == Z_NULL) return {};  // inflate sets this if there is no comment
    const auto end = std::find(s.comment.begin(), s.comment.end(), Bytef{0});
    return {s.comment.begin(), end};
}

}  // namespace macula::splat
