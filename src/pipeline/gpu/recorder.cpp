#include "pipeline/gpu/recorder.h"

#include <array>
#include <utility>

#include "pipeline/gpu/vulkan_error.h"

namespace macula::gpu {
namespace {

constexpr VkImageSubresourceLayers kWholeLayer{VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
constexpr VkImageSubresourceRange kWholeRange{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};

void memoryBarrier(VkCommandBuffer commands, VkPipelineStageFlags2 toStages, VkAccessFlags2 toAccess) {
    VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstStageMask = toStages;
    barrier.dstAccessMask = toAccess;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

void checkRange(const Buffer& buffer, std::uint64_t offset, std::uint64_t bytes) {
    MACULA_CHECK_LE(offset, buffer.bytes());
    MACULA_CHECK_LE(bytes, buffer.bytes() - offset);
}

}  // namespace

Recorder::Scope::Scope(Scope&& other) noexcept
    : recorder_(std::exchange(other.recorder_, nullptr)), timer_(other.timer_) {}

Recorder::Scope::~Scope() {
    if (recorder_) recorder_->endScope(timer_);
}

Result<Recorder> Recorder::create(const std::shared_ptr<Device>& device, std::string_view label) {
    MACULA_CHECK(device != nullptr);
    Recorder recorder;
    MACULA_TRY(recorder.commands_, device->takeCommands());
    recorder.timers_ = TimedSections(recorder.commands_.queries);
    recorder.device_ = device;
    recorder.label_ = label;
    device->dropped_.recorderOpened();
    recorder.state_ = State::recording;
    MACULA_TRY_VOID(recorder.beginCommands());
    return recorder;
}

Result<void> Recorder::beginCommands() {
    device_->setName(VK_OBJECT_TYPE_COMMAND_BUFFER, reinterpret_cast<std::uint64_t>(commands_.buffer),
                     label_);
    VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    if (const VkResult result = vkBeginCommandBuffer(commands_.buffer, &info); result < 0)
        return device_->failed(result, Text("record \"{}\"", label_));
    isEmpty_ = true;
    dirty_ = false;
    return {};
}

Result<void> Recorder::endCommands() {
    // Makes everything written here visible to later submissions and to the host.
    memoryBarrier(commands_.buffer, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_2_HOST_BIT,
                  VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT | VK_ACCESS_2_HOST_READ_BIT);
    if (const VkResult result = vkEndCommandBuffer(commands_.buffer); result < 0)
        return device_->failed(result, Text("record \"{}\"", label_));
    return {};
}

Recorder::Recorder(Recorder&& other) noexcept
    : device_(std::move(other.device_)),
      commands_(other.commands_),
      hostWork_(std::move(other.hostWork_)),
      isEmpty_(other.isEmpty_),
      failed_(std::move(other.failed_)),
      state_(std::exchange(other.state_, State::movedFrom)),
      label_(std::move(other.label_)),
      timers_(std::move(other.timers_)),
      dirty_(other.dirty_),
      ticket_(other.ticket_) {
    MACULA_CHECK_EQ(other.openScopes_, 0);  // scopes point to their recorder
}

Recorder::~Recorder() {
    if (state_ == State::movedFrom) return;
    hostWork_.giveBack([&](CommandPool::Commands commands) {
        commands.busyUntil = ticket_;
        device_->giveCommandsBack(commands);
    });
    commands_.busyUntil = ticket_;
    device_->giveCommandsBack(commands_);
    if (state_ == State::recording) device_->recorderClosed();
}

void Recorder::require(bool fits, const std::string& what) const {
    if (!fits) checkFailed(__FILE__, __LINE__, label_.c_str(), what);
}

void Recorder::barrier() {
    MACULA_CHECK(state_ == State::recording);
    memoryBarrier(commands_.buffer, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                  VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT);
    dirty_ = false;
    isEmpty_ = false;
}

void Recorder::begin(Order order) {
    MACULA_CHECK(state_ == State::recording);
    if (dirty_ && order == Order::afterPrevious) barrier();
    dirty_ = true;
    isEmpty_ = false;
}

void Recorder::bind(const Kernel& kernel, std::span<const std::byte> push, std::span<const Binding> bindings,
                    Order order) {
    begin(order);
    vkCmdBindPipeline(commands_.buffer, VK_PIPELINE_BIND_POINT_COMPUTE, kernel.pipeline());

    std::vector<VkWriteDescriptorSet> writes(bindings.size());
    for (std::size_t i = 0; i < bindings.size(); ++i) {
        const ReflectedBinding& wanted = kernel.reflection().bindings[i];
        const Binding& given = bindings[i];
        writes[i] = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
        writes[i].dstBinding = wanted.binding;
        writes[i].descriptorCount = 1;
        writes[i].descriptorType = wanted.type;
        writes[i].pBufferInfo = &given.buffer_;
        writes[i].pImageInfo = &given.image_;
        writes[i].pTexelBufferView = &given.view_;
    }
    if (!writes.empty())
        device_->functions_.cmdPushDescriptorSet(commands_.buffer, VK_PIPELINE_BIND_POINT_COMPUTE,
                                                 kernel.layout(), 0,
                                                 static_cast<std::uint32_t>(writes.size()), writes.data());
    if (!push.empty())
        vkCmdPushConstants(commands_.buffer, kernel.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0,
                           static_cast<std::uint32_t>(push.size()), push.data());
}

void Recorder::dispatchBytes(const Kernel& kernel, Threads threads, std::span<const std::byte> push,
                             std::span<const Binding> bindings, Order order) {
    kernel.requireFit(push, bindings, label_);
    const std::array<std::uint32_t, 3> wanted{threads.x, threads.y, threads.z};
    std::array<std::uint32_t, 3> groups{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        groups[axis] =
            wanted[axis] / kernel.localSize()[axis] + (wanted[axis] % kernel.localSize()[axis] != 0);
        require(groups[axis] <= device_->maxGroups_[axis],
                fmt::format("{}: {} groups along axis {}, and the device allows {}", kernel.name(),
                            groups[axis], axis, device_->maxGroups_[axis]));
    }
    if (kernel.native()) return dispatchOnHost(kernel, NativeDispatch(groups, push), bindings);
    bind(kernel, push, bindings, order);
    vkCmdDispatch(commands_.buffer, groups[0], groups[1], groups[2]);
}

void Recorder::dispatchIndirect(const Kernel& kernel, const Groups& groups, std::span<const std::byte> push,
                                std::span<const Binding> bindings) {
    MACULA_CHECK(groups.buffer.usage() & VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT);
    MACULA_CHECK_EQ(groups.offset % 4, 0u);
    checkRange(groups.buffer, groups.offset, sizeof(VkDispatchIndirectCommand));
    kernel.requireFit(push, bindings, label_);
    if (kernel.native()) {
        const std::span<std::byte> mapped = groups.buffer.mapped();
        MACULA_CHECK(!mapped.empty());
        return dispatchOnHost(kernel, NativeDispatch({}, push), bindings,
                              mapped.subspan(groups.offset, sizeof(VkDispatchIndirectCommand)));
    }
    bind(kernel, push, bindings, Order::afterPrevious);
    vkCmdDispatchIndirect(commands_.buffer, groups.buffer.handle(), groups.offset);
}

// Ends the current commands, which the device has to complete first, and begins others.
void Recorder::dispatchOnHost(const Kernel& kernel, NativeDispatch dispatch,
                              std::span<const Binding> bindings, std::span<const std::byte> groups) {
    MACULA_CHECK(state_ == State::recording);
    if (failed_) return;
    for (std::size_t i = 0; i < bindings.size(); ++i) {
        require(!bindings[i].mapped_.empty(),
                fmt::format("{}: \"{}\" is not in host memory", kernel.name(), *bindings[i].label_));
        dispatch.bind(kernel.reflection().bindings[i].binding, bindings[i].mapped_);
    }
    const auto tryNext = [&]() -> Result<void> {
        MACULA_TRY(const CommandPool::Commands next, device_->takeCommands());
        const Result<void> ended = endCommands();
        hostWork_.add({.before = std::exchange(commands_, next),
                       .isEmpty = isEmpty_,
                       .kernel = kernel.native(),
                       .dispatch = std::move(dispatch),
                       .groups = groups});
        const Result<void> begun = beginCommands();
        return ended.ok() ? begun : ended;
    };
    if (const auto next = tryNext(); !next.ok()) failed_ = next.error();
}

void Recorder::copy(const Buffer& from, std::uint64_t fromOffset, const Buffer& to, std::uint64_t toOffset,
                    std::uint64_t bytes, Order order) {
    checkRange(from, fromOffset, bytes);
    checkRange(to, toOffset, bytes);
    if (bytes == 0) return;
    begin(order);
    const VkBufferCopy region{fromOffset, toOffset, bytes};
    vkCmdCopyBuffer(commands_.buffer, from.handle(), to.handle(), 1, &region);
}

void Recorder::copy(const Image& from, const Buffer& to, std::uint64_t toOffset, Order order) {
    checkRange(to, toOffset, from.bytes());
    begin(order);
    const VkBufferImageCopy region{toOffset, 0, 0, kWholeLayer, {0, 0, 0}, from.extent()};
    vkCmdCopyImageToBuffer(commands_.buffer, from.handle(), VK_IMAGE_LAYOUT_GENERAL, to.handle(), 1, &region);
}

void Recorder::copy(const Buffer& from, std::uint64_t fromOffset, const Image& to, Order order) {
    checkRange(from, fromOffset, to.bytes());
    begin(order);
    const VkBufferImageCopy region{fromOffset, 0, 0, kWholeLayer, {0, 0, 0}, to.extent()};
    vkCmdCopyBufferToImage(commands_.buffer, from.handle(), to.handle(), VK_IMAGE_LAYOUT_GENERAL, 1, &region);
}

void Recorder::copy(const Image& from, const Image& to, Order order) {
    MACULA_CHECK(from.format() == to.format());
    MACULA_CHECK_EQ(from.extent().width, to.extent().width);
    MACULA_CHECK_EQ(from.extent().height, to.extent().height);
    MACULA_CHECK_EQ(from.extent().depth, to.extent().depth);
    begin(order);
    const VkImageCopy region{kWholeLayer, {0, 0, 0}, kWholeLayer, {0, 0, 0}, from.extent()};
    vkCmdCopyImage(commands_.buffer, from.handle(), VK_IMAGE_LAYOUT_GENERAL, to.handle(),
                   VK_IMAGE_LAYOUT_GENERAL, 1, &region);
}

void Recorder::update(const Buffer& buffer, std::span<const std::byte> bytes, Order order) {
    checkRange(buffer, 0, bytes.size());
    MACULA_CHECK_LE(bytes.size(), kMaxUpdateBytes);
    MACULA_CHECK_EQ(bytes.size() % 4, 0u);
    if (bytes.empty()) return;
    begin(order);
    vkCmdUpdateBuffer(commands_.buffer, buffer.handle(), 0, bytes.size(), bytes.data());
}

void Recorder::copy(const Image& from, const VkRect2D& part, const LentLayer& to) {
    begin(Order::afterPrevious);
    recordCopy(commands_.buffer, from, part, to, device_->queueFamily());
}

void Recorder::fill(const Buffer& buffer, std::uint32_t value, Order order) {
    MACULA_CHECK_EQ(buffer.bytes() % 4, 0u);
    begin(order);
    vkCmdFillBuffer(commands_.buffer, buffer.handle(), 0, VK_WHOLE_SIZE, value);
}

void Recorder::clear(const Image& image, const VkClearColorValue& value, Order order) {
    begin(order);
    vkCmdClearColorImage(commands_.buffer, image.handle(), VK_IMAGE_LAYOUT_GENERAL, &value, 1, &kWholeRange);
}

void Recorder::blit(const Image& from, const BlitTarget& to, VkFilter filter,
                    std::span<const BlitOverlay> overlays) {
    begin(Order::afterPrevious);
    recordBlit(commands_.buffer, from, to, filter, overlays);
}

Recorder::Scope Recorder::label(std::string_view name) {
    MACULA_CHECK(state_ == State::recording);
    ++openScopes_;
    if (device_->functions_.cmdBeginLabel) {
        const std::string terminated(name);
        VkDebugUtilsLabelEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
        info.pLabelName = terminated.c_str();
        device_->functions_.cmdBeginLabel(commands_.buffer, &info);
        isEmpty_ = false;
    }
    return Scope(this, kNoTimer);
}

Recorder::Scope Recorder::timed(std::string_view name) {
    Scope scope = label(name);
    if (device_->timestampBits_ == 0) return scope;
    scope.timer_ = timers_.begin(commands_.buffer, name);
    isEmpty_ = false;
    return scope;
}

void Recorder::endScope(int timer) {
    MACULA_CHECK(state_ == State::recording);
    --openScopes_;
    if (timer != kNoTimer) timers_.end(commands_.buffer, timer);
    isEmpty_ = false;
    if (device_->functions_.cmdEndLabel) device_->functions_.cmdEndLabel(commands_.buffer);
}

Result<Ticket> Recorder::submit(const SubmitOptions& options) {
    MACULA_CHECK(state_ == State::recording);
    MACULA_CHECK_EQ(openScopes_, 0);
    if (failed_) return *failed_;
    MACULA_TRY_VOID(endCommands());
    VkSemaphore wait = options.wait;
    const auto complete = [&](const CommandPool::Commands& before, bool isEmpty) -> Result<void> {
        if (!isEmpty || wait != VK_NULL_HANDLE) {
            MACULA_TRY(ticket_,
                       device_->submit(before.buffer, std::exchange(wait, VK_NULL_HANDLE), VK_NULL_HANDLE));
        }
        return device_->waitForAll();
    };
    MACULA_TRY_VOID(hostWork_.run(complete, label_));
    MACULA_TRY(ticket_, device_->submit(commands_.buffer, wait, options.signal));
    state_ = State::submitted;
    device_->recorderClosed();
    return ticket_;
}

Result<std::vector<Timing>> Recorder::timings() {
    MACULA_CHECK(state_ == State::submitted);
    MACULA_TRY([[maybe_unused]] const bool done, device_->waitFor(ticket_));
    std::vector<Timing> timings;
    const VkResult result =
        timers_.read(device_->handle(), device_->timestampBits_, device_->timestampPeriodNs_, timings);
    if (result < 0) return device_->failed(result, Text("read the timings"));
    return timings;
}

}  // namespace macula::gpu
