// Files of DICOM as one body of multipart/related, read from the disk as it is sent (STOW-RS).
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "net/web/http_exchange.h"

namespace macula::net {

class UploadBody final : public HttpBody {
  public:
    struct Upload {
        std::filesystem::path file;
        std::uint64_t bytes = 0;  // when it was looked at; another size later is an error
    };
    explicit UploadBody(const std::vector<Upload>& uploads);

    std::string contentType() const;
    std::uint64_t size() const override { return size_; }
    Result<std::size_t> read(std::span<std::byte> bytes) override;
    Result<void> rewind() override;

  private:
    // Text, and the file that follows it.
    struct Piece {
        std::string text;
        std::filesystem::path file;  // empty behind the last boundary
        std::uint64_t bytes = 0;
    };
    struct ClosesFile {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    Result<std::size_t> readFile(std::span<std::byte> bytes);

    std::string boundary_;
    std::vector<Piece> pieces_;
    std::uint64_t size_ = 0;
    std::size_t piece_ = 0;
    std::uint64_t atText_ = 0;
    std::uint64_t atFile_ = 0;
    std::unique_ptr<std::FILE, ClosesFile> file_;
};

}  // namespace macula::net
