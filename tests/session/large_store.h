// A store as it is after years: studies of five series each, and a model for every fifth study.
#pragma once

#include <cstdint>
#include <filesystem>

#include "session/model_key.h"

namespace macula::session::test {

// MACULA_SESSION_STUDIES, or so many: at least 100.
int largeStudies(int otherwise);
inline constexpr int kSeriesOfAStudy = 5;
inline constexpr int kStudiesOfAModel = 5;
inline constexpr std::uint64_t kLargeModelBytes = 900'000;

// In one transaction. Models have rows and no blobs.
void fillLargeStore(const std::filesystem::path& folder, int studies);
ModelKey largeModelKey(int i);
std::string largeStudy(int i);

}  // namespace macula::session::test
