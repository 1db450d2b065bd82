// What an archive holds, as the JSON that `macula find` prints.
#include <nlohmann/json.hpp>
#include <string>

#include "c/archive.h"
#include "c/sized.h"
#include "net/archive/query.h"
#include "study/archive/archive_json.h"

namespace macula::c {

namespace {

using Json = nlohmann::ordered_json;

Result<net::StudyQuery> queryOf(const macula_query* given) {
    MACULA_TRY(const macula_query query, taken(given));
    net::StudyQuery asked{.patientName = textOrEmpty(query.patient_name),
                          .patientId = textOrEmpty(query.patient_id),
                          .patientBirthDate = textOrEmpty(query.patient_birth_date),
                          .accessionNumber = textOrEmpty(query.accession_number),
                          .studyId = textOrEmpty(query.study_id),
                          .studyInstanceUid = textOrEmpty(query.study_uid),
                          .dateFrom = textOrEmpty(query.date_from),
                          .dateTo = textOrEmpty(query.date_to),
                          .modality = textOrEmpty(query.modality),
                          .description = textOrEmpty(query.description),
                          .referringPhysician = textOrEmpty(query.referring_physician)};
    if (query.most_answers != 0) asked.mostAnswers = query.most_answers;
    return asked;
}

}  // namespace

extern "C" {

macula_status macula_archive_find(macula_archive* archive, const macula_query* query,
                                  const macula_progress* progress, const char** json) {
    return answer(archive, progress, json, [&](net::Archive& of, Progress& to) -> Result<Json> {
        MACULA_TRY(const net::StudyQuery asked, queryOf(query));
        MACULA_TRY(const net::StudyAnswers found, of.findStudies(asked, to));
        return study::toJson(found);
    });
}

macula_status macula_archive_series(macula_archive* archive, const char* study_uid,
                                    const macula_progress* progress, const char** json) {
    return answer(archive, progress, json, [&](net::Archive& of, Progress& to) -> Result<Json> {
        MACULA_TRY_VOID(checkUid(study_uid));
        MACULA_TRY(const auto series, of.findSeries(study_uid, to));
        return study::toJson(series);
    });
}

}  // extern "C"

}  // namespace macula::c
