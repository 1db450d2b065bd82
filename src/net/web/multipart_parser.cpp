#include "net/web/multipart_parser.h"

#include <algorithm>
#include <cstring>

#include "base/parsing.h"

namespace macula::net {

namespace {

constexpr std::size_t kLongestBoundary = 70;  // RFC 2046 5.1.1
constexpr std::size_t kMostHeaderBytesOfPart = 16 << 10;
constexpr std::size_t kMostIdleBytes = 64 << 10;  // of preamble and epilogue together
constexpr std::size_t kMostBehindBoundary = 256;  // blanks that gateways add

Error malformedBody() {
    return {ErrorCode::archiveNotUsable,
            Text("The archive's answer is not put together as DICOMweb wants it."),
            {},
            Text("Try again; if it happens again, ask the administrator of the archive.")};
}

bool isBlank(char c) {
    return c == ' ' || c == '\t';
}

// A value of a parameter that begins at `at`, which is moved behind it. Quoted or not.
std::string parameterValueAt(std::string_view text, std::size_t& at) {
    std::string value;
    if (at < text.size() && text[at] == '"') {
        for (++at; at < text.size() && text[at] != '"'; ++at) {
            if (text[at] == '\\' && at + 1 < text.size()) ++at;
            value += text[at];
        }
        return value;
    }
    while (at < text.size() && text[at] != ';' && !isBlank(text[at])) value += text[at++];
    return value;
}

}  // namespace

std::string mediaTypeOf(std::string_view contentType) {
    return lowerCase(std::string(trimmed(contentType.substr(0, contentType.find(';')))));
}

std::optional<std::string> boundaryOf(std::string_view contentType) {
    if (!mediaTypeOf(contentType).starts_with("multipart/")) return {};
    std::size_t at = contentType.find(';');
    while (at < contentType.size()) {
        ++at;
        const std::size_t equals = contentType.find_first_of("=;", at);
        if (equals == std::string_view::npos) return {};
        const std::string name = lowerCase(std::string(trimmed(contentType.substr(at, equals - at))));
        at = equals;
        if (contentType[equals] == ';') continue;
        ++at;
        while (at < contentType.size() && isBlank(contentType[at])) ++at;
        std::string value = parameterValueAt(contentType, at);
        if (name == "boundary") {
            const auto mayStand = [](char c) { return c >= ' ' && c <= '~'; };
            const bool isBoundary = !value.empty() && value.size() <= kLongestBoundary &&
                                    value.back() != ' ' && std::ranges::all_of(value, mayStand);
            return isBoundary ? std::optional(std::move(value)) : std::nullopt;
        }
        at = contentType.find(';', at);
    }
    return {};
}

MultipartParser::MultipartParser(const std::string& boundary, PartSink& sink)
    : sink_(sink), delimiter_("\r\n--" + boundary) {
    MACULA_CHECK(!boundary.empty() && boundary.find_first_of("\r\n") == std::string::npos);
}

Result<void> MultipartParser::feed(std::span<const char> bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
        switch (state_) {
            case State::preamble:
            case State::body: {
                MACULA_TRY(at, feedContent(bytes, at));
                break;
            }
            case State::behindBoundary: {
                MACULA_TRY(at, feedBehindBoundary(bytes, at));
                break;
            }
            case State::headers: {
                MACULA_TRY(at, feedHeaders(bytes, at));
                break;
            }
            case State::epilogue:
                return spend(bytes.size() - at);
        }
    }
    return {};
}

Result<void> MultipartParser::spend(std::size_t count) {
    idleBytes_ += count;
    if (idleBytes_ > kMostIdleBytes) return malformedBody();
    return {};
}

Result<void> MultipartParser::content(std::span<const char> bytes) {
    if (bytes.empty()) return {};
    return state_ == State::body ? sink_.partBytes(bytes) : spend(bytes.size());
}

// The delimiter has its only CR at its beginning. So where it does not go on as it should, no other can have
// begun in it, and what has matched is content. What had matched before these bytes need not have been kept:
// it is the delimiter's own text.
Result<std::size_t> MultipartParser::feedContent(std::span<const char> bytes, std::size_t at) {
    const std::size_t from = at;  // content that is not passed on yet begins here
    std::size_t carried = matched_;
    std::size_t matchAt = at;
    while (at < bytes.size()) {
        if (matched_ == 0) {
            const void* const found = std::memchr(bytes.data() + at, '\r', bytes.size() - at);
            matchAt = found == nullptr
                          ? bytes.size()
                          : static_cast<std::size_t>(static_cast<const char*>(found) - bytes.data());
            at = std::min(matchAt + 1, bytes.size());
            matched_ = found == nullptr ? 0 : 1;
        } else if (bytes[at] != delimiter_[matched_]) {
            MACULA_TRY_VOID(
                content(std::span(delimiter_).subspan(borrowed_, carried - std::min(carried, borrowed_))));
            carried = borrowed_ = matched_ = 0;
        } else {
            ++at;
            if (++matched_ == delimiter_.size()) break;
        }
    }
    const std::size_t end = matched_ == 0 ? at : carried > 0 ? from : matchAt;
    MACULA_TRY_VOID(content(bytes.subspan(from, end - from)));
    if (matched_ < delimiter_.size()) return at;
    before_ = state_;
    state_ = State::behindBoundary;
    behind_.clear();
    return at;
}

Result<std::size_t> MultipartParser::feedBehindBoundary(std::span<const char> bytes, std::size_t at) {
    const char c = bytes[at];
    const bool isEnd = behind_ == "-" && c == '-';
    const bool isLineEnd = c == '\n' && behind_.ends_with('\r');
    if (isEnd || isLineEnd) {
        if (before_ == State::body) {
            state_ = State::body;
            MACULA_TRY_VOID(sink_.endPart());
        }
        state_ = isEnd ? State::epilogue : State::headers;
        headers_ = {};
        headerBytes_ = 0;
        line_.clear();
        headerName_.clear();
        headerValue_.clear();
        return at + 1;
    }
    const bool isOnlyBlank = std::ranges::all_of(behind_, isBlank);
    const bool goesOn = (c == '-' && behind_.empty()) || ((isBlank(c) || c == '\r') && isOnlyBlank);
    if (goesOn && behind_.size() < kMostBehindBoundary) {
        behind_ += c;
        return at + 1;
    }
    // The line only begins like the boundary. The last CR may begin another.
    state_ = before_;
    MACULA_TRY_VOID(content(std::span(delimiter_).subspan(borrowed_)));
    const bool endsWithCr = behind_.ends_with('\r');
    if (endsWithCr) behind_.pop_back();
    MACULA_TRY_VOID(content(std::span(behind_.data(), behind_.size())));
    matched_ = endsWithCr ? 1 : 0;
    borrowed_ = 0;
    return at;
}

Result<std::size_t> MultipartParser::feedHeaders(std::span<const char> bytes, std::size_t at) {
    while (at < bytes.size()) {
        const char c = bytes[at++];
        if (++headerBytes_ > kMostHeaderBytesOfPart) return malformedBody();
        if (c != '\n') {
            line_ += c;
            continue;
        }
        if (line_.ends_with('\r')) line_.pop_back();
        const bool isLast = line_.empty();
        MACULA_TRY_VOID(endHeaderLine());
        if (!isLast) continue;
        state_ = State::body;
        matched_ = borrowed_ = 2;  // an empty part: the line end before the boundary is that of the headers
        MACULA_TRY_VOID(sink_.beginPart(headers_));
        return at;
    }
    return at;
}

Result<void> MultipartParser::endHeaderLine() {
    if (!line_.empty() && isBlank(line_.front())) {
        headerValue_ += line_;
        line_.clear();
        return {};
    }
    const std::string_view value = trimmed(headerValue_);
    if (headerName_ == "content-type") headers_.contentType = value;
    if (headerName_ == "content-length") headers_.contentLength = parseNumber<std::uint64_t>(value);
    const std::size_t colon = line_.find(':');
    headerName_.clear();
    headerValue_.clear();
    if (colon != std::string::npos) {
        headerName_ = lowerCase(std::string(trimmed(std::string_view(line_).substr(0, colon))));
        headerValue_ = line_.substr(colon + 1);
    }
    line_.clear();
    return {};
}

}  // namespace macula::net
