// Names of enumerations in JSON.
#pragma once

#include <string>

#include "pipeline/volume/json_reader.h"

namespace macula::scene {

// Reads the name (nameOf) of one of `values`. A missing key leaves `value` as it is.
template <class Values, class T>
void readName(const JsonNode& object, const char* key, const Values& values, T& value) {
    const auto node = object.find(key);
    if (!node) return;
    std::string names;
    for (const auto& each : values) {
        if (nameOf(each) == node->text()) {
            value = each;
            return;
        }
        names += (names.empty() ? "\"" : ", \"") + std::string(nameOf(each)) + "\"";
    }
    node->fail(Text("one of {}", names));
}

}  // namespace macula::scene
