// Takes a body of multipart/related apart as it arrives (RFC 2046 5.1, RFC 2387).
//
// Nothing of a part is kept: its bytes go on as they come. Headers, preamble and epilogue are bounded, and
// each byte is looked at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace macula::net {

// Of `type/subtype; name=value; name="value"`: in lower case, without parameters.
std::string mediaTypeOf(std::string_view contentType);
// The boundary of a multipart type; nothing where there is none, or none that may be one.
std::optional<std::string> boundaryOf(std::string_view contentType);

struct PartHeaders {
    std::string contentType;  // as it stands there; empty if it does not
    std::optional<std::uint64_t> contentLength;
};

// Receives the parts, in their order. An error ends the parsing.
class PartSink {
  public:
    virtual ~PartSink() = default;
    virtual Result<void> beginPart(const PartHeaders& headers) = 0;
    virtual Result<void> partBytes(std::span<const char> bytes) = 0;
    virtual Result<void> endPart() = 0;
};

class MultipartParser {
  public:
    // `sink` must outlive the parser.
    MultipartParser(const std::string& boundary, PartSink& sink);

    // Fails with archiveNotUsable where the body is none of multipart, and with what the sink returned. After
    // that the parser takes no more.
    Result<void> feed(std::span<const char> bytes);
    // Whether the closing delimiter (RFC 2046 5.1.1) has come. A body that ends before it was cut off.
    bool isComplete() const { return state_ == State::epilogue; }

  private:
    enum class State { preamble, body, behindBoundary, headers, epilogue };

    // Each takes what it can of the bytes from `at` on, and returns where it stopped.
    Result<std::size_t> feedContent(std::span<const char> bytes, std::size_t at);
    Result<std::size_t> feedBehindBoundary(std::span<const char> bytes, std::size_t at);
    Result<std::size_t> feedHeaders(std::span<const char> bytes, std::size_t at);
    Result<void> content(std::span<const char> bytes);
    Result<void> endHeaderLine();
    Result<void> spend(std::size_t count);

    PartSink& sink_;
    std::string delimiter_;  // CR LF - - boundary
    State state_ = State::preamble;
    State before_ = State::preamble;  // what the boundary ends: preamble or body
    // How much of the delimiter has matched, and how much of that only seemed to be there: the line end
    // before the first boundary, and that of the headers.
    std::size_t matched_ = 2;
    std::size_t borrowed_ = 2;
    std::string behind_;  // after the boundary, in its line
    std::string line_;    // of a header, as far as it has come
    std::size_t headerBytes_ = 0;
    std::size_t idleBytes_ = 0;  // of preamble and epilogue
    PartHeaders headers_;
    std::string headerName_;
    std::string headerValue_;
};

}  // namespace macula::net
