// Which of several images at one place is of which phase, by a value that orders them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "dicom/split/frame_order.h"

namespace macula::dicom {

// The course of a value along a stack that was imaged several times: ranks at each position, and what the
// value is there for each rank. Made of the positions at which the distances between ranks are the usual
// ones, times a factor (heart beats differ), and where the value is what the positions beside it let expect.
class RankModel {
  public:
    // `values` has one entry for each frame. Nothing when fewer than three quarters of the positions have
    // `ranks` different values at the usual distances: then the order of the values is a matter of chance.
    static std::optional<RankModel> of(const Positions& positions,
                                       std::span<const std::optional<double>> values, std::size_t ranks);

    // Whether the ranks of a position are beyond doubt.
    bool isRegular(std::size_t position) const { return regular_[position]; }
    // The rank of each of these frames of a position, in their order; nothing of one that may have two ranks,
    // or of all where the value does not run steadily along the stack.
    std::vector<std::optional<std::size_t>> ranksOf(std::size_t position,
                                                    std::span<const std::size_t> frames) const;
    // Whether the order at each position means something: the value runs steadily from position to position,
    // or the distances between ranks are the same almost everywhere, or all of a rank comes before the next.
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
    std::vector<std::vector<double>> sorted_;  // values of each position that has as many as there are ranks
    std::vector<bool> regular_;
    std::vector<double> usual_;  // distances from each rank to the next
    bool isSteady_ = false;
    bool isExact_ = false;
    bool isInBlocks_ = false;
};

}  // namespace macula::dicom
