// A store as it is after years: 10 000 studies with 50 000 series, and 2 000 models.
#pragma once

#include <cstdint>
#include <filesystem>

#include "session/model_key.h"

namespace macula::session::test {

inline constexpr int kLargeStudies = 10'000;
inline constexpr int kLargeSeries = 50'000;
inline constexpr int kLargeModels = 2'000;
inline constexpr std::uint64_t kLargeModelBytes = 900'000;

// In one transaction. Models have rows and no blobs.
void fillLargeStore(const std::filesystem::path& folder);
ModelKey largeModelKey(int i);
std::string largeStudy(int i);

}  // namespace macula::session::test
