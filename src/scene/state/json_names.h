// Names of enumerations in JSON.
#pragma once

#include <string>

#include "pipeline/volume/json_reader.h"

namespace macula::app {

// One of `values`, by nameOf; `value` stays as it is where the key is missing.
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
    node->fail("one of " + names);
}

}  // namespace macula::app
