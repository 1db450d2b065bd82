#include "pipeline/splat/files/packed_pictures.h"

#include <utility>

#include "base/check.h"
#include "pipeline/splat/files/byte_planes.h"
#include "pipeline/splat/files/chunk_file.h"
#include "pipeline/splat/files/view_chunks.h"

namespace macula::splat {

Result<void> PackedPictures::pack(std::span<const std::shared_ptr<const TrainingView>> views) {
    auto before = std::exchange(packed_, {});
    std::vector<std::shared_ptr<const TrainingView>> missing;
    std::uint64_t total = 0;
    for (const auto& view : views) {
        MACULA_CHECK(view != nullptr);
        const auto known = before.find(view);
        if (known != before.end()) {
            packed_.insert(before.extract(known));
        } else if (!packed_.contains(view)) {
            missing.push_back(view);
            total += view->pixels.size() * kPixelBytes;
        }
    }
    std::vector<Result<std::vector<std::byte>>> packed(missing.size(), std::vector<std::byte>{});
    forEachChunk(missing.size(), total, [&](std::size_t i) {
        packed[i] = packPlanes(std::as_bytes(std::span(missing[i]->pixels)), kPixelBytes);
    });
    for (std::size_t i = 0; i < missing.size(); ++i) {
        if (!packed[i].ok()) return packed[i].error();
        packed_.emplace(missing[i], std::move(packed[i]).value());
    }
    return {};
}

std::span<const std::byte> PackedPictures::of(const std::shared_ptr<const TrainingView>& view) const {
    const auto found = packed_.find(view);
    MACULA_CHECK(found != packed_.end());
    return found->second;
}

}  // namespace macula::splat
