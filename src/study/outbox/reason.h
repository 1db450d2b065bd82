// Why an archive did not take a file, kept for a person who reads it later.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "base/text.h"

namespace macula::study {

// As in net::NotSent and Error: what is wrong, and what to do.
struct Reason {
    Text why;
    Text advice;

    bool operator==(const Reason&) const = default;
};

// Keeps format and arguments apart, so that each reader sees it in a language of his own.
nlohmann::json toJson(const Reason& reason);
// Nothing where the JSON is no reason.
std::optional<Reason> reasonFromJson(const nlohmann::json& json);

}  // namespace macula::study
