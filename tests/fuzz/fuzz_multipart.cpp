// Any bytes as a body of multipart/related. The first byte says into which pieces it is cut; the rest is a
// content type, a line end, and the body. Every cut gives the same parts, whose bytes are those of the body.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/check.h"
#include "net/web/multipart_parser.h"

namespace macula::net {
namespace {

struct FuzzedParts final : PartSink {
    std::vector<std::string> parts;
    std::size_t bytes = 0;
    bool isOpen = false;

    Result<void> beginPart(const PartHeaders& headers) override {
        MACULA_CHECK(!isOpen);
        MACULA_CHECK_LE(headers.contentType.size(), std::size_t{16} << 10);
        isOpen = true;
        parts.emplace_back();
        return {};
    }
    Result<void> partBytes(std::span<const char> some) override {
        MACULA_CHECK(isOpen && !some.empty());
        parts.back().append(some.data(), some.size());
        bytes += some.size();
        return {};
    }
    Result<void> endPart() override {
        MACULA_CHECK(isOpen);
        isOpen = false;
        return {};
    }
};

struct FuzzedBody {
    FuzzedParts parts;
    bool isComplete = false;
    bool failed = false;
};

FuzzedBody parsedBody(const std::string& boundary, std::string_view body, std::size_t piece) {
    FuzzedBody parsed;
    MultipartParser parser(boundary, parsed.parts);
    for (std::size_t at = 0; at < body.size() && !parsed.failed; at += piece) {
        const std::string_view part = body.substr(at, piece);
        const std::vector<char> copy(part.begin(), part.end());
        const auto fed = parser.feed(copy);
        parsed.failed = !fed.ok();
        if (parsed.failed) MACULA_CHECK(!fed.error().message.empty() && !fed.error().hint.empty());
    }
    parsed.isComplete = parser.isComplete();
    return parsed;
}

}  // namespace
}  // namespace macula::net

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace macula::net;
    if (size == 0) return 0;
    const std::size_t piece = data[0] % 97 + 1;
    const std::string_view all(reinterpret_cast<const char*>(data) + 1, size - 1);
    const std::size_t line = std::min(all.find('\n'), all.size());
    const std::string_view type = all.substr(0, line);
    const std::string_view body = all.substr(std::min(line + 1, all.size()));
    (void)mediaTypeOf(type);
    const auto boundary = boundaryOf(type);
    if (!boundary) return 0;
    const FuzzedBody whole = parsedBody(*boundary, body, std::max<std::size_t>(body.size(), 1));
    const FuzzedBody cut = parsedBody(*boundary, body, piece);
    MACULA_CHECK_LE(whole.parts.bytes, body.size());
    MACULA_CHECK(whole.failed == cut.failed);
    if (whole.failed) return 0;
    MACULA_CHECK(whole.isComplete == cut.isComplete && whole.parts.parts == cut.parts.parts);
    MACULA_CHECK(!whole.isComplete || !whole.parts.isOpen);
    return 0;
}
