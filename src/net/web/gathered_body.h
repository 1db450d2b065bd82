// An answer that is small enough to be held in memory, and a request that is.
#pragma once

#include <algorithm>
#include <cstring>
#include <string>

#include "net/web/http_exchange.h"

namespace macula::net {

// The request's `mostBytes` bounds it.
class GatheredBody final : public HttpSink {
  public:
    Result<void> begin(const HttpHead& head) override {
        head_ = head;
        text_.clear();
        return {};
    }
    Result<void> write(std::span<const std::byte> bytes) override {
        text_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        return {};
    }
    const HttpHead& head() const { return head_; }
    const std::string& text() const { return text_; }

  private:
    HttpHead head_;
    std::string text_;
};

class TextBody final : public HttpBody {
  public:
    explicit TextBody(std::string text) : text_(std::move(text)) {}
    std::uint64_t size() const override { return text_.size(); }
    Result<std::size_t> read(std::span<std::byte> bytes) override {
        const std::size_t count = std::min(bytes.size(), text_.size() - at_);
        if (count > 0) std::memcpy(bytes.data(), text_.data() + at_, count);
        at_ += count;
        return count;
    }
    Result<void> rewind() override {
        at_ = 0;
        return {};
    }

  private:
    std::string text_;
    std::size_t at_ = 0;
};

}  // namespace macula::net
