// Digests of the large parts of scenes: voxels, masks, segments.
#pragma once

#include <cstddef>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "base/volume.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/clip.h"

namespace macula::live {

// No part ever changes: each is read once, however many scenes have it, and its digest dropped when it is
// destroyed. Any thread may call. A caller waits for a digest that another thread is computing, and for no
// other. May throw std::bad_alloc. No patient data.
class PartDigests {
  public:
    std::string of(const std::shared_ptr<const Volume>& volume);  // fingerprint
    std::string of(const std::shared_ptr<const TintBox>& box);    // digest of its voxels
    std::string of(const Mask& mask, const Volume& volume);       // digest of maskBits

    // The number of parts read so far.
    std::size_t made() const;

  private:
    struct Known {
        std::weak_ptr<const void> part;
        std::shared_future<std::string> digest;
    };
    std::string known(const std::shared_ptr<const void>& part, std::string what,
                      const std::function<std::string()>& make);

    mutable std::mutex mutex_;
    // By address, because one owner may have several parts, and by kind of content.
    std::map<std::pair<const void*, std::string>, Known> known_;
    std::size_t made_ = 0;
};

}  // namespace macula::live
