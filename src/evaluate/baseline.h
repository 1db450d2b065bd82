// How a benchmark's ratios stand against those of an earlier run, whose JSON was stored.
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
    // Of `macula-bench NAME`: "trace", "load" or "train". inputNotUsable when the file is no output of that.
    static Result<Baseline> read(const std::filesystem::path& path, std::string_view benchmark);

    // Ratios are only comparable between runs that did the same: fails with inputNotUsable where `report` has
    // another study, preset, kind of device, degree or number of splats. Asks for what it has so far.
    Result<void> checkSame(const nlohmann::ordered_json& report) const;

    // Adds to each object in `results` that has one of these ratios, a positive number here as there,
    // "…OverBaseline": the ratio over that of the same place in the baseline. In lists the same place is the
    // one of the same filter and the same size of picture. What the baseline lacks is not compared.
    void compare(std::span<const std::string_view> ratios, nlohmann::ordered_json& results) const;

  private:
    Baseline(std::filesystem::path path, nlohmann::ordered_json report)
        : path_(std::move(path)), report_(std::move(report)) {}

    std::filesystem::path path_;
    nlohmann::ordered_json report_;
};

}  // namespace macula::evaluate
