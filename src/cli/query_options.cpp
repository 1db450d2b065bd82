#include "cli/query_options.h"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>

namespace macula::cli {

namespace {

bool isDayOrNothing(const std::string& text) {
    const bool digits = std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    return text.empty() || (digits && text.size() == 8);
}

}  // namespace

void addQuery(CLI::App& command, QueryOptions& options) {
    net::StudyQuery& query = options.query;
    command.add_option("--name", query.patientName,
                       "Patient's name; * and ? stand for what is not known: 'DOE^J*'");
    command.add_option("--patient-id", query.patientId, "Patient ID");
    command.add_option("--birth-date", query.patientBirthDate, "YYYYMMDD");
    command.add_option("--accession", query.accessionNumber, "Accession number");
    command.add_option("--study-id", query.studyId, "Study ID");
    command.add_option("--study", query.studyInstanceUid, "Study Instance UID");
    command.add_option("--date", options.date,
                       "Date of the study: YYYYMMDD, or FROM-TO, of which one may be left out");
    command.add_option("--modality", query.modality, "CT, MR, PT …");
    command.add_option("--description", query.description,
                       "Description of the study; * and ? as in the name");
    command.add_option("--referring", query.referringPhysician, "Referring physician");
    command.add_option("--most", query.mostAnswers, "How many studies at most")
        ->capture_default_str()
        ->check(CLI::Range(1, 1'000'000));
}

Result<net::StudyQuery> queryOf(const QueryOptions& options) {
    net::StudyQuery query = options.query;
    const std::size_t dash = options.date.find('-');
    query.dateFrom = options.date.substr(0, dash);
    query.dateTo = dash == std::string::npos ? query.dateFrom : options.date.substr(dash + 1);
    if (!isDayOrNothing(query.dateFrom) || !isDayOrNothing(query.dateTo) ||
        !isDayOrNothing(query.patientBirthDate))
        return Error{ErrorCode::usage,
                     Text("A date is written as YYYYMMDD."),
                     {},
                     Text("For several days: --date 20260101-20260131.")};
    return query;
}

bool isEmpty(const net::StudyQuery& query) {
    const std::string* keys[] = {
        &query.patientName, &query.patientId,        &query.patientBirthDate,  &query.accessionNumber,
        &query.studyId,     &query.studyInstanceUid, &query.dateFrom,          &query.dateTo,
        &query.modality,    &query.description,      &query.referringPhysician};
    return std::all_of(std::begin(keys), std::end(keys), [](const std::string* key) { return key->empty(); });
}

}  // namespace macula::cli
