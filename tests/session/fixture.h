// The contents of the fixtures: fixtures/version_N.sql is a database as version N of the schema had it.
#pragma once

#include <filesystem>
#include <string>

#include "session/store.h"

namespace macula::session::test {

// What a fixture holds, by today's store. The clock goes on by a second with each call of the store.
void fillFixture(const std::filesystem::path& folder);
// Fails the test where the store has anything else, whatever version it was made by.
void expectFixture(Store& store);

// A database as SQL, and back.
std::string sqlOf(const std::filesystem::path& database);
void makeDatabase(const std::string& sql, const std::filesystem::path& database);
// A store's folder as it was when that version was the newest, with its blobs.
void makeFixture(int version, const std::filesystem::path& folder);
std::filesystem::path fixtureFile(int version);

}  // namespace macula::session::test
