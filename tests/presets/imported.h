// Reading presets from texts.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "presets/preset_file.h"

namespace macula::presets {

inline Result<std::string> noTables(const std::string& name) {
    return Error{ErrorCode::inputNotUsable, Text("There is no table {}.", name), {}, Text("Give one.")};
}

inline Result<ImportedPresets> readText(std::string_view text, const std::string& name = "file") {
    return readPresets({text, "/somewhere/" + name, name.substr(0, name.find('.'))}, noTables);
}

// The only preset of a text, or an empty one and a failure of the test.
inline ImportedPreset only(std::string_view text, const std::string& name = "file") {
    const auto read = readText(text, name);
    EXPECT_TRUE(read.ok()) << (read.ok()
                                   ? ""
                                   : read.error().message.english() + " " + read.error().hint.english());
    if (!read.ok()) return {};
    EXPECT_EQ(read->size(), 1u);
    return read->front();
}

// Refused with these words, with what to do, and with the file.
inline void expectRefused(std::string_view text, const std::string& words, const std::string& name = "file") {
    const auto read = readText(text, name);
    ASSERT_FALSE(read.ok()) << text.substr(0, 200);
    EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable);
    EXPECT_NE((read.error().message.english() + " " + read.error().hint.english()).find(words),
              std::string::npos)
        << read.error().message << " " << read.error().hint;
    EXPECT_FALSE(read.error().hint.empty()) << read.error().message;
    EXPECT_EQ(read.error().where, "/somewhere/" + name);
}

}  // namespace macula::presets
