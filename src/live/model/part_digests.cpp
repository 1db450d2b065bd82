#include "live/model/part_digests.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <exception>
#include <span>

#include "base/fingerprint.h"
#include "base/sha256.h"
#include "pipeline/volume/mask_bits.h"

namespace macula::live {

namespace {

std::string digestOf(const MaskBits& bits) {
    return sha256Hex(std::as_bytes(std::span(bits.words)));
}

// What the bits of a mask depend on, besides its labels.
std::string placeOf(const Mask& mask, const Volume& volume) {
    std::string text =
        fmt::format("labels {} {} {} {} {}", mask.keep == Keep::inside, fmt::join(mask.numbers, ","),
                    volume.size().x, volume.size().y, volume.size().z);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) text += fmt::format(" {:a}", volume.worldFromVoxel()[column][row]);
    return text;
}

}  // namespace

std::string PartDigests::of(const std::shared_ptr<const Volume>& volume) {
    return known(volume, "volume", [&] { return fingerprint(*volume); });
}

std::string PartDigests::of(const std::shared_ptr<const TintBox>& box) {
    return known(box, "segments", [&] { return sha256Hex(std::as_bytes(std::span(box->voxels))); });
}

std::string PartDigests::of(const Mask& mask, const Volume& volume) {
    if (mask.bits) return known(mask.bits, "bits", [&] { return digestOf(*mask.bits); });
    return known(mask.labels, placeOf(mask, volume), [&] { return digestOf(maskBits(mask, volume)); });
}

std::size_t PartDigests::made() const {
    const std::lock_guard lock(mutex_);
    return made_;
}

std::string PartDigests::known(const std::shared_ptr<const void>& part, std::string what,
                               const std::function<std::string()>& make) {
    const auto place = std::pair(part.get(), std::move(what));
    std::promise<std::string> made;
    {
        std::unique_lock lock(mutex_);
        // A new part may have the address of one that was destroyed.
        std::erase_if(known_, [](const auto& each) { return each.second.part.expired(); });
        if (const auto found = known_.find(place); found != known_.end()) {
            const std::shared_future<std::string> digest = found->second.digest;
            lock.unlock();
            return digest.get();
        }
        known_.emplace(place, Known{part, made.get_future().share()});
        ++made_;
    }
    try {
        std::string digest = make();
        made.set_value(digest);
        return digest;
    } catch (...) {
        {
            const std::lock_guard lock(mutex_);
            known_.erase(place);  // the next caller tries again
        }
        made.set_exception(std::current_exception());
        throw;
    }
}

}  // namespace macula::live
