#include "pipeline/gpu/reading.h"

#include <algorithm>

#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"

namespace macula::gpu {

namespace {

// Parts begin at offsets that suit any type.
constexpr std::size_t kAlignment = 64;

bool isInHostMemory(const Buffer* buffer) {
    return !buffer->mapped().empty() && buffer->hostCached();
}

}  // namespace

Result<void> Reading::begin(std::initializer_list<const Buffer*> buffers) {
    MACULA_CHECK(buffers.size() > 0);
    MACULA_TRY_VOID(finish());  // copies that are under way write to the same memory
    device_ = (*buffers.begin())->device();
    parts_.clear();
    std::size_t bytes = 0;
    for (const Buffer* buffer : buffers) {
        parts_.push_back({.offset = bytes, .bytes = buffer->bytes()});
        bytes += (buffer->bytes() + kAlignment - 1) / kAlignment * kAlignment;
    }
    if (std::all_of(buffers.begin(), buffers.end(), isInHostMemory)) return readNow(buffers, bytes);
    if (!staging_ || staging_->buffer().bytes() < bytes) {
        staging_.reset();
        Result<Staging> taken = Staging::take(device_, MemoryKind::readback, bytes);
        if (!taken && taken.error().code == ErrorCode::outOfMemory) return readNow(buffers, bytes);
        if (!taken) return taken.error();
        staging_.emplace(std::move(*taken));
    }
    isOwn_ = false;
    MACULA_TRY(auto recorder, Recorder::create(device_, "read on the way"));
    std::size_t i = 0;
    for (const Buffer* buffer : buffers) {
        recorder.copy(*buffer, 0, staging_->buffer(), parts_[i].offset, parts_[i].bytes,
                      i == 0 ? Order::afterPrevious : Order::concurrent);
        device_->countRead(parts_[i++].bytes);
    }
    MACULA_TRY(ticket_, recorder.submit());
    return {};
}

Result<void> Reading::readNow(std::initializer_list<const Buffer*> buffers, std::size_t bytes) {
    isOwn_ = true;
    own_.resize(bytes);
    std::size_t i = 0;
    for (const Buffer* buffer : buffers) {
        MACULA_TRY_VOID(readInto(*buffer, 0, std::span(own_).subspan(parts_[i].offset, parts_[i].bytes)));
        ++i;
    }
    return {};
}

Result<void> Reading::finish() {
    if (ticket_ == 0) return {};
    MACULA_TRY([[maybe_unused]] const bool done, device_->waitFor(ticket_));
    ticket_ = 0;
    return {};
}

std::span<const std::byte> Reading::bytesOf(std::size_t index) const {
    MACULA_CHECK(ticket_ == 0 && index < parts_.size());
    const Part& part = parts_[index];
    if (isOwn_) return std::span(own_).subspan(part.offset, part.bytes);
    return {staging_->data() + part.offset, part.bytes};
}

}  // namespace macula::gpu
