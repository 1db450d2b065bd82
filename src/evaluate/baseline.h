// Compares a benchmark's ratios with those of an earlier run, whose JSON was stored.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace macula::evaluate {

class Baseline {
  public:
    // `benchmark` is the NAME of `macula-bench NAME`: "trace", "load" or "train". Fails with inputNotUsable
    // if the file is not its output.
    static Result<Baseline> read(const std::filesystem::path& path, std::string_view benchmark);

    // Ratios are only comparable between like runs: fails with inputNotUsable if `report` has another study,
    // preset, kind of device, degree or number of splats. Checks those that `report` has so far.
    Result<void> checkSame(const nlohmann::ordered_json& report) const;

    // Adds "…OverBaseline" to each object in `results` that has one of these ratios: this ratio over that at
    // the same place in the baseline, if that is positive. In lists, the same place has the same filter and
    // picture size. Skips what the baseline lacks.
    void compare(std::span<const std::string_view> ratios, nlohmann::ordered_json& results) const;

  private:
    Baseline(std::filesystem::path path, nlohmann::ordered_json report)
        : path_(std::move(path)), report_(std::move(report)) {}

    std::filesystem::path path_;
    nlohmann::ordered_json report_;
};

}  // namespace macula::evaluate
