// The values of the same few pixels of every slice, for comparing slices at a small part of the cost of
// comparing whole ones.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/volume.h"

namespace macula::dicom {

class SliceSamples {
  public:
    // Samples are runs of kRun neighbours in a row, so that noise can be told from edges.
    static constexpr std::size_t kRun = 4;

    // All pixels of tiny slices, some 1000 to 4000 of others, in the order in which pixels are stored.
    SliceSamples(int columns, int rows, std::size_t slices);

    // Takes the samples of a slice from its voxels, in units; padding is NaN. One thread per slice.
    void take(std::size_t slice, std::span<const float> values);
    void take(std::size_t slice, std::span<const std::uint16_t> stored, const UnitsFromStored& map,
              const std::optional<StoredRange>& padding);

    // A multiple of kRun; NaN for slices that were never taken.
    std::span<const float> operator[](std::size_t slice) const {
        return std::span(values_).subspan(slice * perSlice_, perSlice_);
    }

    // The memory of all samples, taken or not.
    std::uint64_t bytes() const { return values_.size() * sizeof(float); }

  private:
    std::vector<std::size_t> runs_;  // where they begin
    std::size_t perSlice_ = 0;
    std::vector<float> values_;
};

}  // namespace macula::dicom
