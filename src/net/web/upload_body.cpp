#include "net/web/upload_body.h"

#include <algorithm>
#include <cstring>
#include <random>

namespace macula::net {

namespace {

// By chance, so that no file holds it.
std::string newBoundary() {
    std::random_device chance;
    std::string boundary = "macula";
    constexpr int kWords = 4;  // 128 bits
    for (int i = 0; i < kWords; ++i) boundary += fmt::format("{:08x}", chance());
    return boundary;
}

}  // namespace

UploadBody::UploadBody(const std::vector<Upload>& uploads) : boundary_(newBoundary()) {
    std::string before;
    for (const Upload& upload : uploads) {
        pieces_.push_back({before + "--" + boundary_ +
                               "\r\nContent-Type: application/dicom\r\nContent-Length: " +
                               std::to_string(upload.bytes) + "\r\n\r\n",
                           upload.file, upload.bytes});
        before = "\r\n";
    }
    pieces_.push_back({before + "--" + boundary_ + "--\r\n", {}, 0});
    for (const Piece& piece : pieces_) size_ += piece.text.size() + piece.bytes;
}

std::string UploadBody::contentType() const {
    return "multipart/related; type=\"application/dicom\"; boundary=" + boundary_;
}

Result<void> UploadBody::rewind() {
    piece_ = 0;
    atText_ = atFile_ = 0;
    file_.reset();
    return {};
}

Result<std::size_t> UploadBody::read(std::span<std::byte> bytes) {
    std::size_t filled = 0;
    while (filled < bytes.size() && piece_ < pieces_.size()) {
        const Piece& piece = pieces_[piece_];
        const std::span<std::byte> rest = bytes.subspan(filled);
        if (atText_ < piece.text.size()) {
            const std::size_t count = std::min<std::size_t>(rest.size(), piece.text.size() - atText_);
            std::memcpy(rest.data(), piece.text.data() + atText_, count);
            atText_ += count;
            filled += count;
        } else if (atFile_ < piece.bytes) {
            MACULA_TRY(const std::size_t count, readFile(rest));
            filled += count;
        } else {
            ++piece_;
            atText_ = atFile_ = 0;
            file_.reset();
        }
    }
    return filled;
}

Result<std::size_t> UploadBody::readFile(std::span<std::byte> bytes) {
    const Piece& piece = pieces_[piece_];
    if (!file_) file_.reset(std::fopen(piece.file.c_str(), "rbe"));
    const std::size_t most = std::min<std::uint64_t>(bytes.size(), piece.bytes - atFile_);
    const std::size_t count = file_ ? std::fread(bytes.data(), 1, most, file_.get()) : 0;
    if (count == 0)
        return Error{ErrorCode::inputNotUsable, Text("A file changed or went away while it was sent."),
                     piece.file.string(), Text("Send it again when nobody else works with it.")};
    atFile_ += count;
    return count;
}

}  // namespace macula::net
