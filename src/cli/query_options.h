// By what a study is searched in an archive.
#pragma once

#include <CLI/App.hpp>
#include <string>

#include "base/result.h"
#include "net/archive/query.h"

namespace macula::cli {

struct QueryOptions {
    net::StudyQuery query;
    std::string date;  // YYYYMMDD, FROM-TO, FROM- or -TO
};

void addQuery(CLI::App& command, QueryOptions& options);

// Fails with usage where a date is none.
Result<net::StudyQuery> queryOf(const QueryOptions& options);
bool isEmpty(const net::StudyQuery& query);

}  // namespace macula::cli
