#include "segment/enclosed.h"

#include "base/parallel.h"

namespace macula::segment {

namespace {

// A region is the room, not an organ, when the field of view bounds more than this share of it.
constexpr double kOpenShare = 1.0 / 3.0;

class SliceFill {
  public:
    SliceFill(const Grid& grid, const std::uint8_t* outside, std::uint8_t* mask)
        : size_(grid.size), outside_(outside), mask_(mask), seen_(grid.sliceSize()) {}

    void run() {
        for (std::size_t seed = 0; seed < seen_.size(); ++seed) {
            if (seen_[seed] == 0 && mask_[seed] == 0 && outside_[seed] == 0) flood(seed);
        }
    }

  private:
    void flood(std::size_t seed) {
        region_.assign(1, seed);
        seen_[seed] = 1;
        open_ = closed_ = 0;
        for (std::size_t next = 0; next < region_.size(); ++next) {
            const std::size_t at = region_[next];
            const int a = int(at % std::size_t(size_.x));
            const int b = int(at / std::size_t(size_.x));
            visit(a > 0, at - 1);
            visit(a + 1 < size_.x, at + 1);
            visit(b > 0, at - std::size_t(size_.x));
            visit(b + 1 < size_.y, at + std::size_t(size_.x));
        }
        if (double(open_) > kOpenShare * double(open_ + closed_)) return;
        for (const std::size_t at : region_) mask_[at] = 1;
    }

    void visit(bool within, std::size_t at) {
        if (!within || outside_[at] != 0) {
            ++open_;
        } else if (seen_[at] == 0 && mask_[at] == 0) {
            seen_[at] = 1;
            region_.push_back(at);
        } else if (seen_[at] == 0) {
            ++closed_;
        }
    }

    glm::ivec3 size_;
    const std::uint8_t* outside_;
    std::uint8_t* mask_;
    Mask seen_;
    std::vector<std::size_t> region_;
    std::size_t open_ = 0;
    std::size_t closed_ = 0;
};

}  // namespace

void fillEnclosed(const Grid& grid, const Mask& outside, Mask& mask, const CancelToken& token) {
    parallelFor(
        std::size_t(grid.size.z),
        [&](std::size_t c) {
            const std::size_t first = c * grid.sliceSize();
            SliceFill(grid, outside.data() + first, mask.data() + first).run();
        },
        token);
}

}  // namespace macula::segment
