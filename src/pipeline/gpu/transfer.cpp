#include "pipeline/gpu/transfer.h"

#include <algorithm>
#include <cstring>

#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/staging_pool.h"

namespace macula::gpu {
namespace {

constexpr std::uint64_t kChunkBytes = StagingPool::kMostBytes;

bool idle(const Device& device) {
    return device.completedTicket() == device.submittedTicket();
}

template <class Record>
Result<Ticket> submitCopy(const std::shared_ptr<Device>& device, const Record& record,
                          std::string_view what) {
    MACULA_TRY(auto recorder, Recorder::create(device, what));
    record(recorder);
    return recorder.submit();
}

}  // namespace

Result<void> uploadTo(const Buffer& buffer, std::uint64_t offsetBytes, std::span<const std::byte> bytes) {
    MACULA_CHECK_LE(offsetBytes, buffer.bytes());
    MACULA_CHECK_LE(bytes.size(), buffer.bytes() - offsetBytes);
    if (bytes.empty()) return {};
    const auto& device = buffer.device();
    MACULA_TRY_VOID(device->checkNotLost(Text("bring data to the graphics device")));
    if (!buffer.mapped().empty() && idle(*device)) {
        std::memcpy(buffer.mapped().data() + offsetBytes, bytes.data(), bytes.size());
        return {};
    }

    // With more than one chunk, the host fills one while the device copies the other.
    const std::uint64_t chunk = std::min<std::uint64_t>(kChunkBytes, bytes.size());
    std::vector<Staging> stages;
    stages.reserve(2);
    while (stages.size() < (chunk < bytes.size() ? 2u : 1u)) {
        MACULA_TRY(Staging stage, Staging::take(device, MemoryKind::upload, chunk));
        stages.push_back(std::move(stage));
    }
    Ticket busyUntil[2] = {0, 0};
    std::size_t slot = 0;
    for (std::uint64_t done = 0; done < bytes.size(); done += chunk, slot = (slot + 1) % stages.size()) {
        const Buffer& stage = stages[slot].buffer();
        const std::uint64_t count = std::min<std::uint64_t>(chunk, bytes.size() - done);
        if (auto free = device->waitFor(busyUntil[slot]); !free.ok()) return free.error();
        std::memcpy(stage.mapped().data(), bytes.data() + done, count);
        MACULA_TRY(busyUntil[slot], submitCopy(
                                        device,
                                        [&](Recorder& recorder) {
                                            recorder.copy(stage, 0, buffer, offsetBytes + done, count);
                                        },
                                        "upload"));
    }
    return {};
}

Result<void> uploadTo(const Image& image, std::span<const std::byte> bytes) {
    MACULA_CHECK_EQ(bytes.size(), image.bytes());
    MACULA_TRY(const Staging stage, Staging::take(image.device(), MemoryKind::upload, bytes.size()));
    std::memcpy(stage.data(), bytes.data(), bytes.size());
    const auto ticket = submitCopy(
        image.device(), [&](Recorder& recorder) { recorder.copy(stage.buffer(), 0, image); }, "upload");
    if (!ticket.ok()) return ticket.error();
    return {};
}

Result<void> readInto(const Buffer& buffer, std::uint64_t offsetBytes, std::span<std::byte> target) {
    MACULA_CHECK_LE(offsetBytes, buffer.bytes());
    MACULA_CHECK_LE(target.size(), buffer.bytes() - offsetBytes);
    if (target.empty()) return {};
    const auto& device = buffer.device();
    device->countRead(target.size());
    if (!buffer.mapped().empty() && buffer.hostCached()) {
        MACULA_TRY_VOID(device->waitForAll());
        std::memcpy(target.data(), buffer.mapped().data() + offsetBytes, target.size());
        return {};
    }

    // Uses smaller chunks if memory is short: reading results back slowly is better than failing.
    MACULA_TRY(const Staging stage, Staging::takeUpTo(device, MemoryKind::readback,
                                                      std::min<std::uint64_t>(kChunkBytes, target.size())));
    const std::uint64_t chunk = stage.buffer().bytes();
    for (std::uint64_t done = 0; done < target.size(); done += chunk) {
        const std::uint64_t count = std::min<std::uint64_t>(chunk, target.size() - done);
        const auto ticket = submitCopy(
            device,
            [&](Recorder& recorder) { recorder.copy(buffer, offsetBytes + done, stage.buffer(), 0, count); },
            "readback");
        if (!ticket.ok()) return ticket.error();
        MACULA_TRY_VOID(device->waitForAll());
        std::memcpy(target.data() + done, stage.data(), count);
    }
    return {};
}

Result<void> readInto(const Image& image, std::span<std::byte> target) {
    MACULA_CHECK_EQ(target.size(), image.bytes());
    image.device()->countRead(target.size());
    MACULA_TRY(const Staging stage, Staging::take(image.device(), MemoryKind::readback, image.bytes()));
    const auto ticket = submitCopy(
        image.device(), [&](Recorder& recorder) { recorder.copy(image, stage.buffer()); }, "readback");
    if (!ticket.ok()) return ticket.error();
    MACULA_TRY_VOID(image.device()->waitForAll());
    std::memcpy(target.data(), stage.data(), target.size());
    return {};
}

Result<std::vector<std::byte>> readBytes(const Buffer& buffer, std::uint64_t offsetBytes,
                                         std::uint64_t bytes) {
    std::vector<std::byte> result(bytes);
    MACULA_TRY_VOID(readInto(buffer, offsetBytes, result));
    return result;
}

Result<std::vector<std::byte>> readBytes(const Image& image) {
    std::vector<std::byte> result(image.bytes());
    MACULA_TRY_VOID(readInto(image, result));
    return result;
}

}  // namespace macula::gpu
