#include "dicom/byte_source.h"

#include <algorithm>
#include <cstring>
#include <new>

namespace macula::dicom {

ByteSource::ByteSource(const std::filesystem::path& file) : file_(file, std::ios::binary) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (!error) fileBytes_ = size;
}

ByteSource::~ByteSource() {
    if (stream_) inflateEnd(stream_.get());
}

std::size_t ByteSource::readFile(unsigned char* target, std::size_t count) {
    file_.read(reinterpret_cast<char*>(target), static_cast<std::streamsize>(count));
    return static_cast<std::size_t>(file_.gcount());
}

bool ByteSource::refill() {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    const std::size_t before = end_;
    if (!stream_) {
        end_ += readFile(buffer_.data() + end_, buffer_.size() - end_);
        return end_ > before;
    }
    while (end_ == before) {
        if (stream_->avail_in == 0) {
            stream_->next_in = compressed_.data();
            stream_->avail_in = static_cast<uInt>(readFile(compressed_.data(), compressed_.size()));
            if (stream_->avail_in == 0) return false;
        }
        stream_->next_out = buffer_.data() + end_;
        stream_->avail_out = static_cast<uInt>(buffer_.size() - end_);
        const int status = inflate(stream_.get(), Z_NO_FLUSH);
        end_ = buffer_.size() - stream_->avail_out;
        if (status != Z_OK) break;
    }
    return end_ > before;
}

bool ByteSource::peek(std::span<unsigned char> bytes) {
    while (end_ - begin_ < bytes.size()) {
        if (!refill()) return false;
    }
    std::memcpy(bytes.data(), buffer_.data() + begin_, bytes.size());
    return true;
}

bool ByteSource::read(std::span<unsigned char> bytes) {
    if (!peek(bytes)) return false;
    begin_ += bytes.size();
    position_ += bytes.size();
    return true;
}

bool ByteSource::skip(std::uint64_t count) {
    if (!stream_) {
        if (count > fileBytes_ || position_ > fileBytes_ - count) return false;
        const std::uint64_t buffered = end_ - begin_;
        position_ += count;
        if (count <= buffered) {
            begin_ += static_cast<std::size_t>(count);
        } else {
            begin_ = end_ = 0;
            file_.clear();
            file_.seekg(static_cast<std::streamoff>(position_));
        }
        return true;
    }
    while (count > 0) {
        if (begin_ == end_ && !refill()) return false;
        const auto step = std::min<std::uint64_t>(count, end_ - begin_);
        begin_ += static_cast<std::size_t>(step);
        position_ += step;
        count -= step;
    }
    return true;
}

void ByteSource::beginInflating() {
    auto stream = std::make_unique<z_stream>();
    *stream = {};
    if (inflateInit2(stream.get(), -MAX_WBITS) != Z_OK) throw std::bad_alloc();
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), compressed_.begin());
    stream->next_in = compressed_.data();
    stream->avail_in = static_cast<uInt>(end_ - begin_);
    begin_ = end_ = 0;
    stream_ = std::move(stream);
}

}  // namespace macula::dicom
