#include "dicom/read/byte_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>

namespace macula::dicom {

namespace {

constexpr std::size_t kFirstRead = 16384;  // holds most headers
constexpr std::size_t kLargestRead = 262144;

}  // namespace

ByteSource::ByteSource(const std::filesystem::path& file, CancelToken cancel)
    : cancel_(std::move(cancel)),
      // Opens without waiting: a pipe in the folder would block.
      descriptor_(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK)),
      step_(kFirstRead) {
    struct stat status {};
    if (descriptor_ < 0 || fstat(descriptor_, &status) != 0) {
        error_ = errno;
    } else if (!S_ISREG(status.st_mode)) {
        error_ = S_ISDIR(status.st_mode) ? EISDIR : EINVAL;
    } else {
        fileBytes_ = static_cast<std::uint64_t>(status.st_size);
    }
}

ByteSource::~ByteSource() {
    if (stream_) inflateEnd(stream_.get());
    if (descriptor_ >= 0) close(descriptor_);
}

std::size_t ByteSource::readFile(unsigned char* target, std::size_t count) {
    if (error_ != 0 || readOffset_ >= fileBytes_) return 0;
    for (;;) {
        const ssize_t got = pread(descriptor_, target, count, static_cast<off_t>(readOffset_));
        if (got >= 0) {
            readOffset_ += static_cast<std::uint64_t>(got);
            return static_cast<std::size_t>(got);
        }
        if (errno != EINTR) {
            error_ = errno;
            return 0;
        }
    }
}

bool ByteSource::refill(std::size_t wanted) {
    if (begin_ > 0) {
        std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
        end_ -= begin_;
        begin_ = 0;
    }
    const std::size_t before = end_;
    const std::size_t room = std::max(end_ + step_, wanted);
    if (buffer_.size() < room) buffer_.resize(room);
    if (!stream_) {
        end_ += readFile(buffer_.data() + end_, room - end_);
        step_ = std::min(2 * step_, kLargestRead);
        return end_ > before;
    }
    while (end_ == before && !cancel_.cancelled()) {
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

std::span<const unsigned char> ByteSource::ahead(std::size_t count) {
    while (end_ - begin_ < count && refill(count)) {
    }
    return {buffer_.data() + begin_, std::min(count, end_ - begin_)};
}

bool ByteSource::peek(std::span<unsigned char> bytes) {
    const auto found = ahead(bytes.size());
    if (found.size() < bytes.size()) return false;
    std::copy(found.begin(), found.end(), bytes.begin());
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
            readOffset_ = position_;
            step_ = kFirstRead;
        }
        return true;
    }
    while (count > 0) {
        if (begin_ == end_ && !refill(1)) return false;
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
    compressed_.assign(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
                       buffer_.begin() + static_cast<std::ptrdiff_t>(end_));
    stream->avail_in = static_cast<uInt>(compressed_.size());
    compressed_.resize(std::max(compressed_.size(), kFirstRead));
    stream->next_in = compressed_.data();
    begin_ = end_ = 0;
    stream_ = std::move(stream);
}

}  // namespace macula::dicom
