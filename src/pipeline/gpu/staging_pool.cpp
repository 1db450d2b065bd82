#include "pipeline/gpu/staging_pool.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace macula::gpu {

Buffer StagingPool::owned(const std::shared_ptr<Device>& device, const Kept& kept) {
    Buffer buffer;
    buffer.memory_ = Handle(device, kept.memory);
    buffer.buffer_ = Handle(device, kept.buffer);
    buffer.label_ = kept.label;
    buffer.bytes_ = kept.bytes;
    buffer.usage_ = kept.usage;
    buffer.mapped_ = kept.mapped;
    buffer.hostCached_ = kept.hostCached;
    return buffer;
}

Result<Buffer> StagingPool::take(const std::shared_ptr<Device>& device, MemoryKind kind,
                                 std::uint64_t bytes) {
    MACULA_CHECK(kind != MemoryKind::deviceLocal && bytes > 0);
    MACULA_TRY_VOID(device->checkNotLost(Text("bring data to the graphics device")));
    const Ticket completed = device->completedTicket();
    auto best = kept_.end();
    for (auto kept = kept_.begin(); kept != kept_.end(); ++kept) {
        if (kept->kind != kind || kept->bytes < bytes || kept->busyUntil > completed) continue;
        if (best == kept_.end() || kept->bytes < best->bytes) best = kept;
    }
    if (best != kept_.end()) return taken(device, best);
    // A buffer too large to be kept gets exactly the size requested.
    const std::uint64_t size =
        bytes > kMostBytes ? bytes : (bytes + kLeastBytes - 1) / kLeastBytes * kLeastBytes;
    MACULA_TRY(Buffer made,
               Buffer::create(device, {.label = "staging", .bytes = size, .usage = 0, .memory = kind}));
    ++made_;
    return made;
}

Buffer StagingPool::taken(const std::shared_ptr<Device>& device, std::vector<Kept>::iterator kept) {
    Buffer buffer = owned(device, *kept);
    kept_.erase(kept);
    return buffer;
}

Result<Buffer> StagingPool::takeUpTo(const std::shared_ptr<Device>& device, MemoryKind kind,
                                     std::uint64_t bytes) {
    Result<Buffer> whole = take(device, kind, bytes);
    if (whole || whole.error().code != ErrorCode::outOfMemory) return whole;
    const Ticket completed = device->completedTicket();
    auto largest = kept_.end();
    for (auto kept = kept_.begin(); kept != kept_.end(); ++kept) {
        if (kept->kind != kind || kept->busyUntil > completed) continue;
        if (largest == kept_.end() || kept->bytes > largest->bytes) largest = kept;
    }
    if (largest != kept_.end()) return taken(device, largest);
    return bytes > kLeastBytes ? take(device, kind, kLeastBytes) : std::move(whole);
}

void StagingPool::giveBack(Buffer buffer, MemoryKind kind) {
    if (buffer.bytes() > kMostBytes) return;
    const std::shared_ptr<Device> device = buffer.device();
    Kept given{.buffer = VK_NULL_HANDLE,
               .memory = VK_NULL_HANDLE,
               .label = buffer.label_,
               .bytes = buffer.bytes_,
               .usage = buffer.usage_,
               .mapped = buffer.mapped_,
               .hostCached = buffer.hostCached_,
               .kind = kind,
               .busyUntil = device->submittedTicket()};
    kept_.reserve(kept_.size() + 1);  // after this nothing throws, so no object is left without an owner
    given.buffer = buffer.buffer_.release();
    given.memory = buffer.memory_.release();
    kept_.push_back(std::move(given));
    const auto isOfKind = [&](const Kept& kept) { return kept.kind == kind; };
    if (std::size_t(std::count_if(kept_.begin(), kept_.end(), isOfKind)) <= kMostOfAKind) return;
    const auto smallest = std::min_element(kept_.begin(), kept_.end(), [&](const Kept& a, const Kept& b) {
        return std::pair(!isOfKind(a), a.bytes) < std::pair(!isOfKind(b), b.bytes);
    });
    const Buffer dropped = owned(device, *smallest);  // freed when nothing uses it
    kept_.erase(smallest);
}

void StagingPool::clear(const std::shared_ptr<Device>& device) {
    for (const Kept& kept : std::exchange(kept_, {})) static_cast<void>(owned(device, kept));
}

void StagingPool::destroyAll(VkDevice device) {
    for (const Kept& kept : std::exchange(kept_, {})) {
        destroyNow(device, kept.buffer);
        destroyNow(device, kept.memory);
    }
}

Result<Staging> Staging::take(const std::shared_ptr<Device>& device, MemoryKind kind, std::uint64_t bytes) {
    MACULA_TRY(Buffer buffer, device->staging().take(device, kind, bytes));
    return Staging(std::move(buffer), kind);
}

Result<Staging> Staging::takeUpTo(const std::shared_ptr<Device>& device, MemoryKind kind,
                                  std::uint64_t bytes) {
    MACULA_TRY(Buffer buffer, device->staging().takeUpTo(device, kind, bytes));
    return Staging(std::move(buffer), kind);
}

Staging::~Staging() {
    if (!buffer_.handle()) return;  // moved from
    const std::shared_ptr<Device> device = buffer_.device();
    device->staging().giveBack(std::move(buffer_), kind_);
}

}  // namespace macula::gpu
