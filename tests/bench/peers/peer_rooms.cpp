#include "tests/bench/peers/peer_rooms.h"

#include <cmath>

namespace bench::crowd {

sim::Vec2 roomOf(int creatures, int creature)
{
    const int side = static_cast<int>(std::ceil(std::sqrt(creatures)));
    return {away * (creature % side), away * (creature / side)};
}

}
