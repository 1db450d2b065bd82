#include "segment/islands.h"

#include <algorithm>
#include <new>
#include <numeric>
#include <vector>

#include "segment/voxel_sets.h"

namespace macula::segment {

namespace {

// Neighbouring voxels of one row.
struct Run {
    int first = 0;
    int last = 0;
};

// Runs, joined into parts with a union of trees.
class Runs {
  public:
    explicit Runs(const VoxelSet& set) : low_(set.low()), size_(set.high() - set.low() + 1) {
        firstOfRow_.assign(std::size_t(size_.y) * std::size_t(size_.z) + 1, 0);
        std::size_t row = 0;
        set.forEach([&](const glm::ivec3& voxel) {
            const std::size_t its = rowOf(voxel.y - low_.y, voxel.z - low_.z);
            while (row < its) firstOfRow_[++row] = runs_.size();
            const bool goesOn = runs_.size() > firstOfRow_[row] && runs_.back().last + 1 == voxel.x;
            if (goesOn) {
                runs_.back().last = voxel.x;
            } else {
                runs_.push_back({voxel.x, voxel.x});
            }
        });
        while (row + 1 < firstOfRow_.size()) firstOfRow_[++row] = runs_.size();
        above_.resize(runs_.size());
        std::iota(above_.begin(), above_.end(), std::size_t(0));
    }

    // False: cancelled.
    bool join(bool corners, Progress& progress) {
        progress.beginStage(Text("Looking for connected parts"), std::size_t(size_.z));
        for (int k = 0; k < size_.z; ++k, progress.advance()) {
            if (progress.cancelled()) return false;
            for (int j = 0; j < size_.y; ++j) {
                if (j > 0) joinRows(rowOf(j, k), rowOf(j - 1, k), corners);
                if (k == 0) continue;
                joinRows(rowOf(j, k), rowOf(j, k - 1), corners);
                if (!corners) continue;
                if (j > 0) joinRows(rowOf(j, k), rowOf(j - 1, k - 1), true);
                if (j + 1 < size_.y) joinRows(rowOf(j, k), rowOf(j + 1, k - 1), true);
            }
        }
        return true;
    }

    // By run: the voxels of its part, counted at the part's first run.
    std::vector<std::size_t> sizes() {
        std::vector<std::size_t> sizes(runs_.size());
        for (std::size_t n = 0; n < runs_.size(); ++n)
            sizes[partOf(n)] += std::size_t(runs_[n].last - runs_[n].first) + 1;
        return sizes;
    }
    std::size_t partOf(std::size_t run) {
        while (above_[run] != run) run = above_[run] = above_[above_[run]];
        return run;
    }
    // The run of a voxel of the set.
    std::size_t runAt(const glm::ivec3& voxel) const {
        std::size_t run = firstOfRow_[rowOf(voxel.y - low_.y, voxel.z - low_.z)];
        while (runs_[run].last < voxel.x) ++run;
        return run;
    }

    template <class Keeps>
    VoxelSet kept(const Keeps& keeps) {
        VoxelSet set(low_, low_ + size_ - 1);
        for (int k = 0; k < size_.z; ++k)
            for (int j = 0; j < size_.y; ++j)
                for (std::size_t n = firstOfRow_[rowOf(j, k)]; n < firstOfRow_[rowOf(j, k) + 1]; ++n) {
                    if (!keeps(partOf(n))) continue;
                    for (int i = runs_[n].first; i <= runs_[n].last; ++i)
                        set.add({i, low_.y + j, low_.z + k});
                }
        return set.cropped();
    }

  private:
    std::size_t rowOf(int j, int k) const { return std::size_t(k) * std::size_t(size_.y) + std::size_t(j); }

    void joinRows(std::size_t row, std::size_t other, bool corners) {
        const int reach = corners ? 1 : 0;
        std::size_t b = firstOfRow_[other];
        for (std::size_t a = firstOfRow_[row]; a < firstOfRow_[row + 1]; ++a) {
            while (b < firstOfRow_[other + 1] && runs_[b].last + reach < runs_[a].first) ++b;
            for (std::size_t n = b; n < firstOfRow_[other + 1] && runs_[n].first - reach <= runs_[a].last;
                 ++n)
                unite(a, n);
        }
    }
    // The earlier run stands for both.
    void unite(std::size_t a, std::size_t b) {
        a = partOf(a);
        b = partOf(b);
        above_[std::max(a, b)] = std::min(a, b);
    }

    glm::ivec3 low_;
    glm::ivec3 size_;
    std::vector<Run> runs_;
    std::vector<std::size_t> firstOfRow_;  // one more than rows
    std::vector<std::size_t> above_;       // of each run: one of its part that is earlier, or itself
};

Error noMemory() {
    return {ErrorCode::outOfMemory,
            Text("There is not enough memory to look for connected parts."),
            {},
            Text("Close other programs.")};
}

// Calls use(runs) with joined runs of a set that is not empty.
template <class Value, class Use>
Result<Value> withParts(const VoxelSet& set, bool corners, Progress& progress, const Use& use) try {
    const VoxelSet small = set.cropped();
    if (small.isEmpty()) return Value();
    Runs runs(small);
    if (!runs.join(corners, progress)) return segmentingCancelled();
    return use(runs);
} catch (const std::bad_alloc&) {
    return noMemory();
}

}  // namespace

Result<VoxelSet> largestIsland(const VoxelSet& set, bool corners, Progress& progress) {
    return withParts<VoxelSet>(set, corners, progress, [](Runs& runs) {
        const std::vector<std::size_t> sizes = runs.sizes();
        const auto largest = std::size_t(std::ranges::max_element(sizes) - sizes.begin());
        return runs.kept([&](std::size_t part) { return part == largest; });
    });
}

Result<VoxelSet> withoutSmallIslands(const VoxelSet& set, std::size_t fewest, bool corners,
                                     Progress& progress) {
    return withParts<VoxelSet>(set, corners, progress, [fewest](Runs& runs) {
        const std::vector<std::size_t> sizes = runs.sizes();
        return runs.kept([&](std::size_t part) { return sizes[part] >= fewest; });
    });
}

Result<VoxelSet> islandOf(const VoxelSet& set, const glm::ivec3& voxel, bool corners, Progress& progress) {
    if (!set.contains(voxel)) return VoxelSet();
    return withParts<VoxelSet>(set, corners, progress, [&voxel](Runs& runs) {
        const std::size_t part = runs.partOf(runs.runAt(voxel));
        return runs.kept([part](std::size_t each) { return each == part; });
    });
}

Result<std::size_t> islandCount(const VoxelSet& set, bool corners, Progress& progress) {
    return withParts<std::size_t>(set, corners, progress, [](Runs& runs) {
        const std::vector<std::size_t> sizes = runs.sizes();
        return std::size_t(std::ranges::count_if(sizes, [](std::size_t voxels) { return voxels > 0; }));
    });
}

Result<VoxelSet> withoutHoles(const VoxelSet& set, Progress& progress) try {
    const VoxelSet small = set.cropped();
    if (small.isEmpty()) return VoxelSet();
    // One voxel more on each side, so that all that is outside is one part: that of the first run.
    const VoxelSet rest = complement(small, small.low() - 1, small.high() + 1);
    MACULA_TRY(const VoxelSet holes, withParts<VoxelSet>(rest, false, progress, [](Runs& runs) {
                   return runs.kept([](std::size_t part) { return part != 0; });
               }));
    return united(small, holes);
} catch (const std::bad_alloc&) {
    return noMemory();
}

}  // namespace macula::segment
