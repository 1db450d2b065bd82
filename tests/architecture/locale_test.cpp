// Numbers are read the same in every locale: a desktop may write a half as "0,5".
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <string>
#include <string_view>

#include "architecture/sources.h"
#include "base/paths.h"

namespace {

constexpr std::array kReadByLocale{"strtod(", "strtof(", "strtold(", "atof(", "stod(", "stof(", "stold("};

// Of a function by that name, and not of one whose name ends so.
bool calls(std::string_view line, std::string_view function) {
    for (std::size_t at = line.find(function); at != std::string_view::npos;
         at = line.find(function, at + 1)) {
        const char before = at == 0 ? ' ' : line[at - 1];
        if (std::isalnum(static_cast<unsigned char>(before)) == 0 && before != '_') return true;
    }
    return false;
}

// "%lf" or "%8f" and the like in what scanf is given.
bool scansFractions(std::string_view line) {
    if (line.find("scanf(") == std::string_view::npos) return false;
    for (std::size_t at = line.find('%'); at != std::string_view::npos; at = line.find('%', at + 1)) {
        const std::size_t kind = line.find_first_not_of("*0123456789lL", at + 1);
        if (kind != std::string_view::npos && std::string_view("efgaEFGA").find(line[kind]) != line.npos)
            return true;
    }
    return false;
}

bool readsByLocale(std::string_view line) {
    return scansFractions(line) ||
           std::ranges::any_of(kReadByLocale, [&](const char* function) { return calls(line, function); });
}

TEST(Locale, WhatReadsByItIsFound) {
    EXPECT_TRUE(readsByLocale("x = std::strtod(text.c_str(), nullptr);"));
    EXPECT_TRUE(readsByLocale("stof(text);"));
    EXPECT_TRUE(readsByLocale("std::sscanf(t, \"%lf,%8lf%n\", &a, &b, &used);"));
    EXPECT_FALSE(readsByLocale("std::sscanf(t, \"%6dx%6d%n\", &a, &b, &used);"));
    EXPECT_FALSE(readsByLocale("fmt::format(\"{} %f\", x);"));
    EXPECT_FALSE(readsByLocale("x = nameOf(y), z = myatof(y);"));
}

TEST(Locale, NumbersAreReadWithoutIt) {
    std::size_t lines = 0;
    for (const auto& path : macula::test::sourcesIn("src")) {
        std::ifstream text(path);
        int number = 0;
        for (std::string line; std::getline(text, line); ++lines) {
            ++number;
            EXPECT_FALSE(readsByLocale(line))
                << path.lexically_relative(macula::test::projectFolder()) << ":" << number
                << " reads a number as the desktop writes it: see base/parsing.h";
        }
    }
    EXPECT_GT(lines, 10'000u) << "the sources were not found";
}

}  // namespace
