// The cumulative dose-volume histogram (DVH) of a region: how much of it receives at least a dose.
#pragma once

#include <cstddef>
#include <vector>

namespace macula::study {

// Of samples that stand for equal volumes. Between two samples, each taken as the middle of its volume, it is
// linear. Without samples all figures are NaN.
class DoseHistogram {
  public:
    DoseHistogram() = default;
    // The samples are finite.
    explicit DoseHistogram(std::vector<float> samples);

    bool isEmpty() const { return samples_.empty(); }
    std::size_t count() const { return samples_.size(); }
    double minimum() const;
    double maximum() const;
    double mean() const { return mean_; }

    // D: the dose that this share of the volume, 0 to 1, receives at least: doseAt(0.95) is D95.
    double doseAt(double share) const;
    // V: the share of the volume that receives at least this dose; the inverse of doseAt. 1 up to the
    // minimum, 0 above the maximum.
    double shareAt(double dose) const;

  private:
    std::vector<float> samples_;  // ascending
    double mean_ = 0.0;
};

}  // namespace macula::study
