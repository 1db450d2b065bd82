// Datasets of storage commitment (PS3.4 J.3): what an archive is asked about, and what it reports.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace macula::net {

struct ReferencedInstance {
    std::string sopClassUid;
    std::string sopInstanceUid;
};

// `transferSyntax`: Explicit or Implicit VR Little Endian.
std::vector<unsigned char> commitmentRequestBytes(const std::string& transactionUid,
                                                  std::span<const ReferencedInstance> instances,
                                                  std::string_view transferSyntax);

struct CommitmentReport {
    std::string transactionUid;
    std::set<std::string> committed;               // SOP Instance UIDs
    std::map<std::string, std::uint16_t> refused;  // with the reason (0008,1197)
};

// Nothing where the bytes are malformed or name no transaction. Items without a UID are left out.
std::optional<CommitmentReport> commitmentReportOf(std::span<const unsigned char> bytes,
                                                   std::string_view transferSyntax);

}  // namespace macula::net
