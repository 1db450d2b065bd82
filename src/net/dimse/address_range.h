// Addresses of IPv4 and IPv6 that have their first bits in common.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "net/dimse/wire.h"

namespace macula::net {

class AddressRange {
  public:
    // An address, or a range of them in CIDR's notation: "192.168.1.7", "10.1.0.0/16", "2001:db8::/32".
    // Nothing for other text, such as host names, which whoever answers for names could change.
    static std::optional<AddressRange> of(std::string_view text);
    // Those of this machine alone: 127.0.0.0/8 and ::1.
    static bool isLoopback(const WireAddress& address);

    bool contains(const WireAddress& address) const;

  private:
    using Bytes = std::array<unsigned char, 16>;  // of IPv6; those of IPv4 are ::ffff:a.b.c.d
    static std::optional<Bytes> bytesOf(const WireAddress& address);

    Bytes bytes_{};
    unsigned bits_ = 128;
};

// As numbers, those of IPv4 as such; empty where it is neither.
std::string textOf(const WireAddress& address);

// Whether only this machine reaches an address that somebody listens at.
bool isOfThisMachineAlone(const std::string& address);

}  // namespace macula::net
