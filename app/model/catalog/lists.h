#pragma once

#include <algorithm>

namespace app {

/// Returns whether `list` has `value`.
template <class List, class Value>
bool contains(const List &list, const Value &value)
{
    return std::find(list.begin(), list.end(), value) != list.end();
}

/// Returns the first entry of `list` with this `id`; null if there is none.
template <class List, class Id>
auto *findById(List &list, const Id &id)
{
    const auto found = std::find_if(list.begin(), list.end(), [&](const auto &one) { return one.id == id; });
    return found == list.end() ? nullptr : &*found;
}

}
