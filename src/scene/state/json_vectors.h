// Points, directions and whole values of a study's state in JSON. Only for the readers and writers of this
// folder.
#pragma once

#include <nlohmann/json.hpp>

#include "base/volume.h"
#include "pipeline/volume/json_reader.h"

namespace macula::scene {

// The error in the length of a unit vector in double precision.
inline constexpr double kUnitRounding = 1e-12;

// [x, y, z]
nlohmann::ordered_json list(const glm::dvec3& v);
glm::dvec3 vector(const JsonNode& node);  // within 1 km

// A unit vector; the same bits if it already is one. Fails for zeros.
glm::dvec3 direction(const JsonNode& node);

// Whether a reader accepts what was written.
template <class From>
bool isTaken(const nlohmann::ordered_json& json, const From& from) {
    const JsonDocument document = JsonDocument::of(nlohmann::json(json), {});
    from(document.root());
    return document.status().ok();
}

}  // namespace macula::scene
