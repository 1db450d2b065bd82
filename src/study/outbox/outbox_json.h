// The queue, as the command prints it. Names patients.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "study/outbox/outbox.h"
#include "study/outbox/queue_sending.h"

namespace macula::study {

nlohmann::ordered_json toJson(const std::vector<OutboxEntry>& entries);
nlohmann::ordered_json toJson(const QueueSent& sent);

// "waiting", "sending", "refused", "damaged"
const char* nameOf(OutboxState state);

}  // namespace macula::study
