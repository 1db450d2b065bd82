// Work for the GPU: recorded in order, submitted once.
//
//   MACULA_TRY(auto recorder, gpu::Recorder::create(device, "frame"));
//   {
//       auto timer = recorder.timed("trace");
//       recorder.dispatch(kernel, {width, height}, params, {volume, lut, image});
//   }
//   MACULA_TRY(const gpu::Ticket ticket, recorder.submit());
//
// On a device of type CPU, kernels that have a twin on the host (native_kernel.h) run within submit(), in
// their place among the commands: submit() then returns when the last of them is done.
//
// A dispatch that does not match its shader (another size of push constants, another number or kind of
// bindings) is a failed check that names the kernel and the binding.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/binding.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/foreign_images.h"
#include "pipeline/gpu/host_work.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/gpu/timed_sections.h"

namespace macula::gpu {

// Threads, not groups; rounded up to whole groups, so a shader must test its invocation against the actual
// size.
struct Threads {
    std::uint32_t x = 1;
    std::uint32_t y = 1;
    std::uint32_t z = 1;
};

// Whether a command waits for the commands before it. `concurrent` saves a barrier between commands that
// touch different data.
enum class Order { afterPrevious, concurrent };

struct SubmitOptions {
    VkSemaphore wait =
        VK_NULL_HANDLE;  // binary, awaited before any command runs: Swapchain::Frame::available
    VkSemaphore signal = VK_NULL_HANDLE;  // binary, signalled when all is done: Swapchain::Frame::rendered
};

// Equivalent of a VkCommandBuffer in recording state. Movable, not copyable; one thread. While any recorder
// of a device is open, nothing dropped is destroyed: submit or drop it soon. Dropping it unsubmitted discards
// the commands.
class Recorder {
  public:
    // Ends a label or a timed section when it goes out of scope. Must not outlive its recorder, nor its
    // submission.
    class Scope {
      public:
        Scope(Scope&& other) noexcept;
        Scope& operator=(Scope&&) = delete;
        ~Scope();

      private:
        friend class Recorder;
        Scope(Recorder* recorder, int timer) : recorder_(recorder), timer_(timer) {}
        Recorder* recorder_;
        int timer_;  // kNoTimer: label only
    };

    static Result<Recorder> create(const std::shared_ptr<Device>& device, std::string_view label);

    Recorder(Recorder&& other) noexcept;
    Recorder& operator=(Recorder&&) = delete;
    ~Recorder();

    // Bindings in the order of their binding numbers. Push is the struct in the shader's push_constant block.
    template <class Push>
    requires std::is_trivially_copyable_v<Push>
    void dispatch(const Kernel& kernel, Threads threads, const Push& push,
                  std::initializer_list<Binding> bindings, Order order = Order::afterPrevious) {
        dispatchBytes(kernel, threads, std::as_bytes(std::span(&push, 1)), bindings, order);
    }
    template <class Push>
    requires std::is_trivially_copyable_v<Push>
    void dispatch(const Kernel& kernel, Threads threads, const Push& push, std::span<const Binding> bindings,
                  Order order = Order::afterPrevious) {
        dispatchBytes(kernel, threads, std::as_bytes(std::span(&push, 1)), bindings, order);
    }
    // For a shader without push constants.
    void dispatch(const Kernel& kernel, Threads threads, std::initializer_list<Binding> bindings,
                  Order order = Order::afterPrevious) {
        dispatchBytes(kernel, threads, {}, bindings, order);
    }
    void dispatch(const Kernel& kernel, Threads threads, std::span<const Binding> bindings,
                  Order order = Order::afterPrevious) {
        dispatchBytes(kernel, threads, {}, bindings, order);
    }
    void dispatchBytes(const Kernel& kernel, Threads threads, std::span<const std::byte> push,
                       std::span<const Binding> bindings, Order order = Order::afterPrevious);

    // An indirect dispatch. When the device reaches it, it reads the number of groups (not threads) from a
    // VkDispatchIndirectCommand, three uints, at a multiple of 4 bytes in a buffer with
    // VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT. Whoever writes them must keep to the device's limits: every device
    // allows 65535 groups along each axis.
    struct Groups {
        const Buffer& buffer;
        std::uint64_t offset = 0;
    };
    template <class Push>
    requires std::is_trivially_copyable_v<Push>
    void dispatch(const Kernel& kernel, const Groups& groups, const Push& push,
                  std::initializer_list<Binding> bindings) {
        dispatchIndirect(kernel, groups, std::as_bytes(std::span(&push, 1)), bindings);
    }
    void dispatch(const Kernel& kernel, const Groups& groups, std::initializer_list<Binding> bindings) {
        dispatchIndirect(kernel, groups, {}, bindings);
    }

    // Ranges must lie within the buffers; offsets and sizes of fill are multiples of 4.
    void copy(const Buffer& from, std::uint64_t fromOffset, const Buffer& to, std::uint64_t toOffset,
              std::uint64_t bytes, Order order = Order::afterPrevious);
    void copy(const Image& from, const Buffer& to, std::uint64_t toOffset = 0,
              Order order = Order::afterPrevious);
    void copy(const Buffer& from, std::uint64_t fromOffset, const Image& to,
              Order order = Order::afterPrevious);
    // Both images have the same size and format.
    void copy(const Image& from, const Image& to, Order order = Order::afterPrevious);
    // Copies a part of the image, bit by bit, to the top left corner of a layer of the same texel size:
    // display-encoded values stay so in an sRGB image. The layer's previous content is lost. Afterwards the
    // image is ready for its owner.
    void copy(const Image& from, const VkRect2D& part, const LentLayer& to);
    // Writes a few bytes that travel in the command buffer itself: at most kMaxUpdateBytes, a multiple of 4.
    // So the host need not wait until earlier work has read the previous content.
    void update(const Buffer& buffer, std::span<const std::byte> bytes, Order order = Order::afterPrevious);
    void fill(const Buffer& buffer, std::uint32_t value, Order order = Order::afterPrevious);  // all of it
    void clear(const Image& image, const VkClearColorValue& value, Order order = Order::afterPrevious);

    // Scales the whole 2D image over the whole target, whose previous content is lost, and which is then
    // ready to be presented. Values are converted to the target's format, not encoded: write display-encoded
    // values.
    void blit(const Image& from, const BlitTarget& to, VkFilter filter = VK_FILTER_NEAREST,
              std::span<const BlitOverlay> overlays = {});

    // Makes later commands wait for earlier ones. Only needed around Order::concurrent and commands().
    void barrier();

    [[nodiscard]] Scope label(std::string_view name);  // for debuggers
    [[nodiscard]] Scope timed(std::string_view name);  // a label whose time is measured; at most kMaxTimers

    static constexpr int kMaxTimers = TimedSections::kMost;
    static constexpr std::size_t kMaxUpdateBytes = 65536;  // Vulkan's own limit

    // The command buffer, for commands that this class does not offer. Put barrier() before and after.
    VkCommandBuffer commands() const { return commands_.buffer; }

    // May be called once. The work starts now; the recorder may be dropped at once, or kept to read timings.
    // Where native kernels are among the work, what comes before one that fails is done.
    Result<Ticket> submit(const SubmitOptions& options = {});

    // The timed sections in order of their start; none where the queue has no timestamps. Waits for the
    // submission.
    Result<std::vector<Timing>> timings();

  private:
    enum class State { recording, submitted, movedFrom };

    Recorder() = default;
    void require(bool fits, const std::string& what) const;
    void begin(Order order);
    void dispatchIndirect(const Kernel& kernel, const Groups& groups, std::span<const std::byte> push,
                          std::span<const Binding> bindings);
    void bind(const Kernel& kernel, std::span<const std::byte> push, std::span<const Binding> bindings,
              Order order);
    void dispatchOnHost(const Kernel& kernel, NativeDispatch dispatch, std::span<const Binding> bindings,
                        std::span<const std::byte> groups = {});
    Result<void> beginCommands();
    Result<void> endCommands();
    void endScope(int timer);

    static constexpr int kNoTimer = -1;

    std::shared_ptr<Device> device_;
    CommandPool::Commands commands_;
    HostWork hostWork_;
    bool isEmpty_ = true;          // nothing was recorded in commands_
    std::optional<Error> failed_;  // while recording; submit() returns it
    State state_ = State::movedFrom;
    std::string label_;
    TimedSections timers_;  // with the queries of the first commands
    int openScopes_ = 0;
    bool dirty_ = false;  // something was recorded since the last barrier
    Ticket ticket_ = 0;
};

}  // namespace macula::gpu
