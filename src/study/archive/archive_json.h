// What archives answer, as the command and the Python package print it. Names patients.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "net/archive/archive.h"
#include "study/archive/fetched_study.h"
#include "study/archive/received_studies.h"

namespace macula::study {

nlohmann::ordered_json toJson(const net::StudyAnswers& answers);
nlohmann::ordered_json toJson(const std::vector<net::FoundSeries>& series);
nlohmann::ordered_json toJson(const FetchedStudy& fetched);
nlohmann::ordered_json toJson(const ReceivedStudy& received);
nlohmann::ordered_json toJson(const net::Sent& sent);
nlohmann::ordered_json toJson(const std::vector<net::Commitment>& commitments);
nlohmann::ordered_json toJson(const std::vector<net::TestStep>& steps);

}  // namespace macula::study
