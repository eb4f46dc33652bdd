#include "app/model/breakpoints/breakpoints.h"

#include "app/model/breakpoints/condition.h"
#include "app/model/catalog/lists.h"
#include "app/model/listing/changed_lines.h"

#include <algorithm>
#include <utility>

namespace app {

const Breakpoint *Breakpoints::find(int id) const
{
    return findById(m_open.all, id);
}

const Breakpoint *Breakpoints::at(const CodePlace &place) const
{
    const auto found = std::find_if(m_open.all.begin(), m_open.all.end(),
                                    [&](const Breakpoint &one) { return one.place == place; });
    return found == m_open.all.end() ? nullptr : &*found;
}

void Breakpoints::open(const QString &key)
{
    if (key == m_key)
        return;
    m_closed[m_key] = std::move(m_open);
    m_key = key;
    m_open = std::move(m_closed[key]);
    emit changed();
}

bool Breakpoints::toggle(const CodePlace &place)
{
    const Breakpoint *there = at(place);
    if (there)
        std::erase_if(m_open.all, [&](const Breakpoint &one) { return one.place == place; });
    else
        m_open.all.push_back({++m_last, place, {}, true});
    emit changed();
    return !there;
}

void Breakpoints::add(const QString &condition)
{
    m_open.all.push_back({++m_last, std::nullopt, condition, true});
    emit changed();
}

void Breakpoints::setCondition(int id, const QString &condition)
{
    Breakpoint *one = findById(m_open.all, id);
    if (!one || one->condition == condition)
        return;
    one->condition = condition;
    emit changed();
}

void Breakpoints::setOn(int id, bool on)
{
    Breakpoint *one = findById(m_open.all, id);
    if (!one || one->isOn == on)
        return;
    one->isOn = on;
    emit changed();
}

void Breakpoints::remove(int id)
{
    if (std::erase_if(m_open.all, [id](const Breakpoint &one) { return one.id == id; }) > 0)
        emit changed();
}

void Breakpoints::renameBody(const QString &from, const QString &to)
{
    const std::vector<Breakpoint> before = m_open.all;
    for (Breakpoint &one : m_open.all)
        one.condition = withBodyRenamed(one.condition, from, to);
    if (m_open.all != before)
        emit changed();
}

void Breakpoints::followListing(const QString &text)
{
    if (m_open.listing == text)
        return;
    const QString before = std::exchange(m_open.listing, text).value_or(text);
    const auto isInListing = [](const Breakpoint &one) { return one.place && one.place->isInListing(); };
    if (before == text || std::none_of(m_open.all.begin(), m_open.all.end(), isInListing))
        return;
    const std::vector<int> moved = movedLines(before, text);
    std::vector<Breakpoint> kept;
    for (Breakpoint one : m_open.all) {
        if (isInListing(one)) {
            const auto line = static_cast<std::size_t>(one.place->line);
            one.place->line = line < moved.size() ? moved[line] : 0;
            const bool isTaken = std::any_of(
                kept.begin(), kept.end(), [&](const Breakpoint &other) { return other.place == one.place; });
            if (one.place->line == 0 || isTaken)
                continue;
        }
        kept.push_back(std::move(one));
    }
    if (kept == m_open.all)
        return;
    m_open.all = std::move(kept);
    emit changed();
}

}
