// Assigns the images at one place to phases, by a value that orders them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "dicom/split/frame_order.h"

namespace macula::dicom {

// A model of a value along a stack that was imaged several times: the value of each rank at each position.
// Built from the positions at which the distances between ranks are the usual ones, up to a factor (heart
// beats differ), and where the value fits that of the neighbouring positions.
class RankModel {
  public:
    // `values` has one entry for each frame. Nothing when fewer than three quarters of the positions have
    // `ranks` different values at the usual distances: then the order of the values may be chance.
    static std::optional<RankModel> of(const Positions& positions,
                                       std::span<const std::optional<double>> values, std::size_t ranks);

    // Whether the ranks of a position are certain.
    bool isRegular(std::size_t position) const { return regular_[position]; }
    // The rank of each of these frames of a position, in their order; nothing for a frame that may have two
    // ranks, and for all frames of an irregular position if the value does not run steadily along the stack.
    std::vector<std::optional<std::size_t>> ranksOf(std::size_t position,
                                                    std::span<const std::size_t> frames) const;
    // Whether the order at each position is meaningful: the value runs steadily along the stack, or the
    // distances between ranks are equal almost everywhere, or all of a rank comes before the next.
    bool isFirm() const { return isSteady_ || isExact_ || isInBlocks_; }

  private:
    void findUsualDistances();
    bool hasUsualDistances(std::size_t position, double tolerance) const;
    void findSteadiness();
    void findBlocks();
    std::optional<std::vector<double>> expectedAt(std::size_t position) const;
    double leastDistance() const;

    std::size_t ranks_ = 0;
    std::span<const std::optional<double>> values_;
    std::vector<double> alongMm_;
    std::vector<std::vector<double>> sorted_;  // values of each position with one value for each rank
    std::vector<bool> regular_;
    std::vector<double> usual_;  // distances from each rank to the next
    bool isSteady_ = false;
    bool isExact_ = false;
    bool isInBlocks_ = false;
};

}  // namespace macula::dicom
