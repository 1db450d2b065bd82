#include "pipeline/trace/indirect_cache.h"

#include <cmath>
#include <cstring>
#include <span>

#include "pipeline/gpu/transfer.h"
#include "shaders/trace.h"

namespace macula::trace {

namespace {

// After so many records without a free place the cache is cleared: most cells then hold light that is out of
// view.
constexpr std::uint32_t kMostDropped = 1u << 12;

std::uint32_t dividedUp(int a, int b) {
    return static_cast<std::uint32_t>((a + b - 1) / b);
}

std::uint32_t recordsOf(const shared::TraceParams& params) {
    const int stride = params.indirectStride;
    return dividedUp(params.imageSize.x, stride) * dividedUp(params.imageSize.y, stride);
}

}  // namespace

Result<IndirectCache::Tables> IndirectCache::makeTables(const std::shared_ptr<gpu::Device>& device,
                                                        std::uint64_t buckets, std::uint64_t records) {
    constexpr VkBufferUsageFlags kUsage =
        VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    const auto texels = [&](const char* label, std::uint64_t elements) {
        return gpu::TexelBuffer::create(
            device,
            {.label = label, .elements = elements, .format = VK_FORMAT_R32G32B32A32_UINT, .usage = kUsage});
    };
    MACULA_TRY(gpu::TexelBuffer tags, texels("tags of indirect light", buckets));
    MACULA_TRY(gpu::TexelBuffer cells, texels("indirect light", buckets * shared::kIndirectWays));
    MACULA_TRY(gpu::Buffer told,
               gpu::Buffer::create(device, {.label = "indirect light that was found",
                                            .bytes = records * sizeof(shared::IndirectRecord)}));
    MACULA_TRY(gpu::Buffer dropped, gpu::Buffer::create(device, {.label = "indirect light that was dropped",
                                                                 .bytes = sizeof(std::uint32_t),
                                                                 .memory = gpu::MemoryKind::readback}));
    return Tables{std::move(tags), std::move(cells), std::move(told), std::move(dropped)};
}

Result<void> IndirectCache::makeBindable() {
    if (tables_) return {};
    MACULA_TRY(tables_, makeTables(device_, 1, 1));
    return {};
}

Result<void> IndirectCache::prepare(const LightOfScene& light) {
    if (!isUsable_) {
        tables_.reset();
        MACULA_TRY(tables_, makeTables(device_, shared::kIndirectBuckets, shared::kIndirectMostRecords));
        isUsable_ = true;
        light_.reset();
    }
    if (!add_) {
        MACULA_TRY(add_, gpu::Kernel::create(device_, shaders::trace_indirect_add_comp));
    }
    if (light_ == light && !isFull()) return {};
    light_.reset();
    MACULA_TRY_VOID(forget());
    light_ = light;
    return {};
}

// As of some earlier dispatch, because it does not wait for the device.
bool IndirectCache::isFull() const {
    std::uint32_t dropped = 0;
    std::memcpy(&dropped, tables_->dropped.mapped().data(), sizeof(dropped));
    return dropped > kMostDropped;
}

Result<void> IndirectCache::forget() {
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "forget indirect light"));
    recorder.fill(tables_->tags.buffer(), 0);
    recorder.fill(tables_->cells.buffer(), 0);
    recorder.fill(tables_->records, 0);
    recorder.fill(tables_->dropped, 0);
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return {};
}

void IndirectCache::appendTo(std::vector<gpu::Binding>& bindings) const {
    bindings.emplace_back(tables_->tags);
    bindings.emplace_back(tables_->cells);
    bindings.emplace_back(tables_->records);
}

Result<void> IndirectCache::add(gpu::Recorder& recorder, const shared::TraceParams& params) {
    const shared::IndirectPush push{.recordCount = recordsOf(params), .unit = params.indirectUnit};
    recorder.dispatch(*add_, {push.recordCount}, push,
                      {tables_->records, tables_->tags.buffer(), tables_->cells.buffer(), tables_->dropped});
    return {};
}

Result<IndirectCache::Content> IndirectCache::read() const {
    Content content;
    MACULA_TRY(content.tags, gpu::read<std::uint32_t>(tables_->tags.buffer()));
    MACULA_TRY(content.cells, gpu::read<glm::uvec4>(tables_->cells.buffer()));
    return content;
}

Result<void> IndirectCache::write(const Content& content) {
    MACULA_TRY_VOID(gpu::uploadTo(tables_->tags.buffer(), std::span<const std::uint32_t>(content.tags)));
    return gpu::uploadTo(tables_->cells.buffer(), std::span<const glm::uvec4>(content.cells));
}

}  // namespace macula::trace
