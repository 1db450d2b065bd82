// Bodies of multipart/related: every cut into pieces gives the same parts, and nothing hostile is kept.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "net/web/multipart_parser.h"

namespace macula::net {
namespace {

struct GatheredParts final : PartSink {
    struct Part {
        PartHeaders headers;
        std::string bytes;
        bool hasEnded = false;
    };
    std::vector<Part> parts;

    Result<void> beginPart(const PartHeaders& headers) override {
        EXPECT_TRUE(parts.empty() || parts.back().hasEnded);
        parts.push_back({headers, {}, false});
        return {};
    }
    Result<void> partBytes(std::span<const char> bytes) override {
        EXPECT_FALSE(parts.back().hasEnded);
        EXPECT_FALSE(bytes.empty());
        parts.back().bytes.append(bytes.data(), bytes.size());
        return {};
    }
    Result<void> endPart() override {
        parts.back().hasEnded = true;
        return {};
    }
    std::vector<std::string> texts() const {
        std::vector<std::string> all;
        for (const Part& part : parts) all.push_back(part.bytes + (part.hasEnded ? "" : "…"));
        return all;
    }
};

struct Parsed {
    std::vector<std::string> texts;
    bool isComplete = false;
    bool failed = false;

    bool operator==(const Parsed&) const = default;
};

Parsed parsed(const std::string& body, std::size_t piece, const std::string& boundary = "B") {
    GatheredParts sink;
    MultipartParser parser(boundary, sink);
    Parsed result;
    for (std::size_t at = 0; at < body.size() && !result.failed; at += piece) {
        // A copy of its own, so that a sanitizer sees what is read behind the piece.
        const std::vector<char> bytes(
            body.begin() + static_cast<std::ptrdiff_t>(at),
            body.begin() + static_cast<std::ptrdiff_t>(std::min(body.size(), at + piece)));
        result.failed = !parser.feed(bytes).ok();
    }
    result.texts = sink.texts();
    result.isComplete = parser.isComplete();
    return result;
}

void expectParts(const std::string& body, const std::vector<std::string>& texts, bool isComplete = true) {
    for (std::size_t piece = 1; piece <= body.size() + 1; ++piece) {
        const Parsed result = parsed(body, piece);
        EXPECT_EQ(result.texts, texts) << "pieces of " << piece;
        EXPECT_EQ(result.isComplete, isComplete) << "pieces of " << piece;
        EXPECT_FALSE(result.failed) << "pieces of " << piece;
    }
}

TEST(Multipart, BoundariesAreFoundInTypes) {
    const auto of = [](const char* type) { return boundaryOf(type).value_or("none"); };
    EXPECT_EQ(of("multipart/related; type=\"application/dicom\"; boundary=abc"), "abc");
    EXPECT_EQ(of("Multipart/Related;BOUNDARY=\"a;b=c\\\"d\"; type=x"), "a;b=c\"d");
    EXPECT_EQ(of("multipart/related; flag; boundary = x "), "x");
    EXPECT_EQ(of("multipart/related; start=\"boundary=no\"; boundary=yes"), "yes");
    EXPECT_EQ(of("application/dicom; boundary=abc"), "none");
    EXPECT_EQ(of("multipart/related"), "none");
    EXPECT_EQ(of("multipart/related; boundary="), "none");
    EXPECT_EQ(of("multipart/related; boundary=\"a\rb\""), "none");
    EXPECT_EQ(of(("multipart/related; boundary=" + std::string(71, 'x')).c_str()), "none");
    EXPECT_EQ(mediaTypeOf(" Application/DICOM ; x=y"), "application/dicom");
}

TEST(Multipart, PartsComeWholeHoweverTheyAreCut) {
    expectParts("--B\r\n\r\none\r\n--B\r\nA: b\r\n\r\ntwo\r\n--B--", {"one", "two"});
    expectParts("\r\n--B\r\n\r\n\r\n--B\r\n\r\n\r\n\r\n--B--\r\nafter", {"", "\r\n"});
    expectParts("before\r\nmore\r\n--B \t\r\n\r\none\r\n--B--after", {"one"});
    // Empty, where the line end before the boundary is that of the headers.
    expectParts("--B\r\n\r\n--B\r\nX: y\r\n\r\n--B--", {"", ""});
    expectParts("--B--", {});
}

TEST(Multipart, WhatOnlyLooksLikeABoundaryIsContent) {
    for (const char* text : {"\r\n--", "\r\n--b", "--B", "\r--B\n", "\r\r\n-\r\n\r\n--A", "\r\n--BB",
                             "\r\n--B-", "\r\n--B \rx", "\r\n--B\r\r\n--B-x", "\r\n\r\n\r\n"}) {
        expectParts("--B\r\n\r\n" + std::string(text) + "x\r\n--B--", {std::string(text) + "x"});
    }
}

TEST(Multipart, OfACutBodyThePartsAreNotWhole) {
    const std::string body = "--B\r\n\r\none\r\n--B\r\n\r\ntwo\r\n--B--";
    const std::string beforeEnd = body.substr(0, body.size() - 1);
    expectParts(beforeEnd, {"one", "two…"}, false);
    expectParts(body.substr(0, body.find("two") + 2), {"one", "tw…"}, false);
    for (std::size_t bytes = 0; bytes < body.size(); ++bytes)
        EXPECT_FALSE(parsed(body.substr(0, bytes), 7).isComplete);
}

TEST(Multipart, HeadersAreReadAndBounded) {
    GatheredParts sink;
    MultipartParser parser("B", sink);
    const std::string body =
        "--B\r\nCONTENT-type:  application/dicom;\r\n transfer-syntax=1.2\r\nContent-Length: "
        "3\r\nnone\r\n\r\none\r\n--B--";
    ASSERT_TRUE(parser.feed(body).ok());
    ASSERT_EQ(sink.parts.size(), 1u);
    EXPECT_EQ(sink.parts[0].headers.contentType, "application/dicom; transfer-syntax=1.2");
    EXPECT_EQ(sink.parts[0].headers.contentLength, 3u);

    for (const std::string& endless :
         {std::string("--B\r\nA: ") + std::string(1 << 20, 'x'), std::string(1 << 20, 'p'),
          std::string("--B--") + std::string(1 << 20, 'e')}) {
        const Parsed result = parsed(endless, 4096);
        EXPECT_TRUE(result.failed);
        EXPECT_TRUE(result.texts.empty());
    }
}

TEST(Multipart, ChanceOfTwoLettersGivesTheSameInEveryCut) {
    std::mt19937 chance(1);
    constexpr std::string_view kLetters = "\r\n-B";
    for (int i = 0; i < 300; ++i) {
        std::string body = "--B\r\n\r\n";
        for (int n = 0; n < 60; ++n) body += kLetters[chance() % kLetters.size()];
        const Parsed whole = parsed(body, body.size());
        for (const std::size_t piece : {1, 2, 3, 5, 11}) EXPECT_EQ(parsed(body, piece), whole) << body;
    }
}

TEST(Multipart, AnErrorOfTheSinkEndsIt) {
    struct Full final : PartSink {
        Result<void> beginPart(const PartHeaders&) override { return {}; }
        Result<void> partBytes(std::span<const char>) override {
            return Error{ErrorCode::outputNotWritable, Text("Full."), {}, {}};
        }
        Result<void> endPart() override { return {}; }
    } sink;
    MultipartParser parser("B", sink);
    const auto fed = parser.feed(std::string("--B\r\n\r\none\r\n--B--"));
    ASSERT_FALSE(fed.ok());
    EXPECT_EQ(fed.error().code, ErrorCode::outputNotWritable);
}

}  // namespace
}  // namespace macula::net
