#include "net/dimse/address_range.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <cstring>

#include "base/parsing.h"

namespace macula::net {

namespace {

constexpr std::array<unsigned char, 12> kPrefixOfIpv4{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff};
constexpr unsigned kBitsBeforeIpv4 = 96;

bool isIpv4(const std::array<unsigned char, 16>& bytes) {
    return std::equal(kPrefixOfIpv4.begin(), kPrefixOfIpv4.end(), bytes.begin());
}

}  // namespace

std::optional<AddressRange::Bytes> AddressRange::bytesOf(const WireAddress& address) {
    Bytes bytes{};
    if (address.family == AF_INET6) {
        std::memcpy(bytes.data(), &reinterpret_cast<const sockaddr_in6*>(address.bytes)->sin6_addr, 16);
        return bytes;
    }
    if (address.family != AF_INET) return {};
    std::copy(kPrefixOfIpv4.begin(), kPrefixOfIpv4.end(), bytes.begin());
    std::memcpy(bytes.data() + 12, &reinterpret_cast<const sockaddr_in*>(address.bytes)->sin_addr, 4);
    return bytes;
}

std::optional<AddressRange> AddressRange::of(std::string_view text) {
    const std::size_t slash = text.find('/');
    const std::string address(text.substr(0, slash));
    AddressRange range;
    unsigned before = 0;
    if (inet_pton(AF_INET, address.c_str(), range.bytes_.data() + 12) == 1) {
        std::copy(kPrefixOfIpv4.begin(), kPrefixOfIpv4.end(), range.bytes_.begin());
        before = kBitsBeforeIpv4;
    } else if (inet_pton(AF_INET6, address.c_str(), range.bytes_.data()) != 1) {
        return {};
    }
    if (slash == std::string_view::npos) return range;
    const auto bits = parseNumber<unsigned>(text.substr(slash + 1));
    if (!bits || *bits > 128 - before) return {};
    range.bits_ = before + *bits;
    return range;
}

bool AddressRange::contains(const WireAddress& address) const {
    const std::optional<Bytes> bytes = bytesOf(address);
    if (!bytes) return false;
    for (unsigned bit = 0; bit < bits_; ++bit) {
        const unsigned difference = (*bytes)[bit / 8] ^ bytes_[bit / 8];
        if ((difference >> (7 - bit % 8) & 1u) != 0) return false;
    }
    return true;
}

bool AddressRange::isLoopback(const WireAddress& address) {
    static const auto ofIpv4 = of("127.0.0.0/8");
    static const auto ofIpv6 = of("::1");
    return ofIpv4->contains(address) || ofIpv6->contains(address);
}

std::string textOf(const WireAddress& address) {
    char text[INET6_ADDRSTRLEN] = {};
    if (address.family == AF_INET) {
        inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(address.bytes)->sin_addr, text, sizeof text);
    } else if (address.family == AF_INET6) {
        std::array<unsigned char, 16> bytes{};
        std::memcpy(bytes.data(), &reinterpret_cast<const sockaddr_in6*>(address.bytes)->sin6_addr, 16);
        if (isIpv4(bytes))
            inet_ntop(AF_INET, bytes.data() + 12, text, sizeof text);
        else
            inet_ntop(AF_INET6, bytes.data(), text, sizeof text);
    }
    return text;
}

bool isOfThisMachineAlone(const std::string& address) {
    WireAddress number;
    auto* ipv4 = reinterpret_cast<sockaddr_in*>(number.bytes);
    auto* ipv6 = reinterpret_cast<sockaddr_in6*>(number.bytes);
    if (inet_pton(AF_INET, address.c_str(), &ipv4->sin_addr) == 1)
        number.family = AF_INET;
    else if (inet_pton(AF_INET6, address.c_str(), &ipv6->sin6_addr) == 1)
        number.family = AF_INET6;
    else
        return address == "localhost";
    return AddressRange::isLoopback(number);
}

}  // namespace macula::net
